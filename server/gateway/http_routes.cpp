// SPDX-License-Identifier: MIT
#include "gateway/http_routes.h"

#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gateway/http_status.h"
#include "jostle/v1/query.pb.h"
#include "jostle/v1/world.pb.h"

namespace jostle::server {

namespace {

constexpr std::string_view worlds_path = "/api/worlds";
constexpr std::string_view query_path = "/api/query/";

HttpResponse json(int status, std::string body) {
    HttpResponse response;
    response.status = status;
    response.content_type = "application/json";
    response.headers.emplace_back("Cache-Control", "no-store");
    response.body = std::move(body);
    return response;
}

HttpResponse json(int status, const google::protobuf::Message& message) {
    google::protobuf::util::JsonPrintOptions options;
    options.always_print_primitive_fields = true;  // a reader in a browser sees zeros, not holes
    std::string body;
    const auto written = google::protobuf::util::MessageToJsonString(message, &body, options);
    if (!written.ok()) {
        return to_http(Error{ErrorCode::internal, "The answer could not be written as JSON."});
    }
    return json(status, std::move(body));
}

HttpResponse text(int status, std::string body) {
    HttpResponse response;
    response.status = status;
    response.headers.emplace_back("Cache-Control", "no-store");
    response.body = std::move(body);
    return response;
}

HttpResponse method_not_allowed(std::string allowed) {
    HttpResponse response = text(405, "This path takes " + allowed + ".\n");
    response.headers.emplace_back("Allow", std::move(allowed));
    return response;
}

// "http://host:port" to "host:port".
std::string_view host_of_origin(std::string_view origin) {
    const std::size_t at = origin.find("://");
    return at == std::string_view::npos ? std::string_view{} : origin.substr(at + 3);
}

// The body of a request that changes or asks something; an answer when it is none.
std::optional<HttpResponse> read_json(google::protobuf::Message& message,
                                      const HttpRequest& request) {
    // Forms can send text from any page without asking the server first; JSON they cannot.
    if (!request.content_type.starts_with("application/json")) {
        return text(415, "Send the body as JSON, with Content-Type: application/json.\n");
    }
    const auto read = google::protobuf::util::JsonStringToMessage(request.body, &message);
    if (read.ok()) return std::nullopt;
    return to_http(Error{ErrorCode::invalid_argument,
                         "The body is not a " + message.GetDescriptor()->full_name() +
                             " as JSON: " + std::string(read.message())});
}

// Reads a question, asks it, writes the answer.
template <class Request, class Response>
HttpResponse ask(const HttpRequest& request, const QueryControl& queries,
                 Status (QueryControl::*method)(const Request&, Response&, const StillWanted&)
                     const) {
    Request message;
    if (const auto refused = read_json(message, request)) return *refused;
    Response response;
    const Status status = (queries.*method)(message, response, QueryControl::always);
    return status.ok() ? json(200, response) : to_http(status.error());
}

}  // namespace

HttpResponse to_http(const Error& error) {
    const HttpCode code = http_code_of(error.code);
    const nlohmann::json body = {{"code", code.name}, {"message", error.message}};
    HttpResponse response = json(
        code.status, body.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
    if (code.status == 503 || code.status == 429) response.headers.emplace_back("Retry-After", "5");
    return response;
}

HttpRoutes::HttpRoutes(WorldControl& worlds, const QueryControl& queries, RouteSettings settings)
    : worlds_(worlds),
      queries_(queries),
      settings_(std::move(settings)),
      files_(settings_.web_root) {}

HttpWork HttpRoutes::work_of(const HttpRequest& request) const {
    const std::string_view path = path_of(request.target);
    if (path.starts_with(query_path)) return HttpWork::asks;
    const bool reads = request.method == "GET" || request.method == "HEAD";
    return reads || !path.starts_with("/api/") ? HttpWork::at_once : HttpWork::changes;
}

bool HttpRoutes::takes_players(const HttpRequest& request) const {
    return path_of(request.target) == "/play";
}

bool HttpRoutes::takes_large_body(const HttpRequest& request) const {
    const std::string_view path = path_of(request.target);
    return request.method == "POST" && (path == worlds_path || path.starts_with(query_path));
}

bool HttpRoutes::origin_is_allowed(const HttpRequest& request) const {
    if (request.origin.empty()) return true;
    if (!request.host.empty() && host_of_origin(request.origin) == request.host) return true;
    return std::ranges::find(settings_.allowed_origins, request.origin) !=
           settings_.allowed_origins.end();
}

HttpResponse HttpRoutes::answer(const HttpRequest& request) const {
    const std::string_view path = path_of(request.target);
    if (path == "/healthz" || path == "/readyz") {
        if (const auto trouble = settings_.trouble()) return text(503, *trouble + "\n");
        if (path == "/healthz") return text(200, "ok\n");
        return settings_.is_draining() ? text(503, "the server is going down\n")
                                       : text(200, "ready\n");
    }
    if (path == "/api" || path.starts_with("/api/")) return answer_api(request, path);
    if (path == "/play") {
        HttpResponse response = text(426, "This path takes WebSocket clients.\n");
        response.headers.emplace_back("Upgrade", "websocket");
        return response;
    }
    return files_.serve(request);
}

HttpResponse HttpRoutes::answer_api(const HttpRequest& request, std::string_view path) const {
    const bool changes = request.method != "GET" && request.method != "HEAD";
    if (changes && !origin_is_allowed(request)) {
        return text(403, "A page from another origin may not use this server.\n");
    }
    if (path == worlds_path) {
        if (!changes) return list_worlds();
        if (request.method == "POST") return create_world(request);
        return method_not_allowed("GET, POST");
    }
    if (path.starts_with("/api/worlds/")) {
        const std::optional<std::string> relative = relative_path_of(path);
        if (!relative) return to_http(Error{ErrorCode::invalid_argument, "The path is malformed."});
        const std::string world = relative->substr(worlds_path.size());  // without the first '/'
        if (world.find('/') == std::string::npos) {
            if (!changes) return get_world(world);
            if (request.method == "DELETE") return delete_world(world);
            return method_not_allowed("GET, DELETE");
        }
    }
    if (path.starts_with(query_path)) {
        if (request.method != "POST") return method_not_allowed("POST");
        return query(request, path.substr(query_path.size()));
    }
    return to_http(
        Error{ErrorCode::not_found,
              "There is no such path; /api/worlds, /api/worlds/{id} and /api/query/{method} "
              "are what there is."});
}

HttpResponse HttpRoutes::list_worlds() const {
    v1::ListWorldsResponse response;
    const Status status = worlds_.list({}, response);
    return status.ok() ? json(200, response) : to_http(status.error());
}

HttpResponse HttpRoutes::get_world(const std::string& world) const {
    v1::GetWorldRequest request;
    request.set_world(world);
    v1::GetWorldResponse response;
    const Status status = worlds_.get(request, response);
    return status.ok() ? json(200, response) : to_http(status.error());
}

HttpResponse HttpRoutes::create_world(const HttpRequest& request) const {
    v1::CreateWorldRequest message;
    if (const auto refused = read_json(message, request)) return *refused;
    v1::CreateWorldResponse response;
    const Status status = worlds_.create(message, response);
    return status.ok() ? json(201, response) : to_http(status.error());
}

HttpResponse HttpRoutes::query(const HttpRequest& request, std::string_view method) const {
    if (method == "CastRays") return ask(request, queries_, &QueryControl::cast_rays);
    if (method == "CastShapes") return ask(request, queries_, &QueryControl::cast_shapes);
    if (method == "Overlap") return ask(request, queries_, &QueryControl::overlap);
    if (method == "ClosestPoints") return ask(request, queries_, &QueryControl::closest_points);
    if (method == "Debug") return ask(request, queries_, &QueryControl::debug);
    return to_http(Error{ErrorCode::not_found,
                         "There is no such query; CastRays, CastShapes, Overlap, ClosestPoints and "
                         "Debug are what there is."});
}

HttpResponse HttpRoutes::delete_world(const std::string& world) const {
    v1::DeleteWorldRequest request;
    request.set_world(world);
    v1::DeleteWorldResponse response;
    const Status status = worlds_.remove(request, response);
    return status.ok() ? json(200, response) : to_http(status.error());
}

}  // namespace jostle::server
