// SPDX-License-Identifier: MIT
#include "gateway/http_routes.h"

#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <nlohmann/json.hpp>

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
        return to_http({AnswerCode::internal, "The answer could not be written as JSON."});
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

struct Words {
    int status;
    std::string_view name;
};

Words words_of(AnswerCode code) {
    switch (code) {
        case AnswerCode::ok:
            return {200, "OK"};
        case AnswerCode::invalid_argument:
            return {400, "INVALID_ARGUMENT"};
        case AnswerCode::not_found:
            return {404, "NOT_FOUND"};
        case AnswerCode::already_exists:
            return {409, "ALREADY_EXISTS"};
        case AnswerCode::failed_precondition:
            return {409, "FAILED_PRECONDITION"};
        case AnswerCode::unauthenticated:
            return {401, "UNAUTHENTICATED"};
        case AnswerCode::resource_exhausted:
            return {429, "RESOURCE_EXHAUSTED"};
        case AnswerCode::deadline_exceeded:
            return {504, "DEADLINE_EXCEEDED"};
        case AnswerCode::aborted:
            return {409, "ABORTED"};
        case AnswerCode::unavailable:
            return {503, "UNAVAILABLE"};
        case AnswerCode::internal:
            return {500, "INTERNAL"};
    }
    return {500, "INTERNAL"};
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
    return to_http({AnswerCode::invalid_argument, "The body is not a " +
                                                      message.GetDescriptor()->full_name() +
                                                      " as JSON: " + std::string(read.message())});
}

// Reads a question, asks it, writes the answer.
template <class Request, class Response>
HttpResponse ask(const HttpRequest& request, const QueryControl& queries,
                 Answer (QueryControl::*method)(const Request&, Response&) const) {
    Request message;
    if (const auto refused = read_json(message, request)) return *refused;
    Response response;
    const Answer answer = (queries.*method)(message, response);
    return answer.ok() ? json(200, response) : to_http(answer);
}

}  // namespace

HttpResponse to_http(const Answer& answer) {
    const Words words = words_of(answer.code);
    const nlohmann::json body = {{"code", words.name}, {"message", answer.message}};
    HttpResponse response = json(
        words.status, body.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
    if (words.status == 503 || words.status == 429)
        response.headers.emplace_back("Retry-After", "5");
    return response;
}

HttpRoutes::HttpRoutes(WorldControl& worlds, const QueryControl& queries, RouteSettings settings)
    : worlds_(worlds),
      queries_(queries),
      settings_(std::move(settings)),
      files_(settings_.web_root) {}

bool HttpRoutes::may_take_long(const HttpRequest& request) {
    return path_of(request.target).starts_with("/api/");
}

bool HttpRoutes::origin_is_allowed(const HttpRequest& request) const {
    if (request.origin.empty()) return true;
    if (!request.host.empty() && host_of_origin(request.origin) == request.host) return true;
    return std::ranges::find(settings_.allowed_origins, request.origin) !=
           settings_.allowed_origins.end();
}

HttpResponse HttpRoutes::answer(const HttpRequest& request) const {
    const std::string_view path = path_of(request.target);
    if (path == "/healthz") return text(200, "ok\n");
    if (path == "/readyz") {
        return settings_.is_ready() ? text(200, "ready\n") : text(503, "not ready\n");
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
        if (!relative) return to_http({AnswerCode::invalid_argument, "The path is malformed."});
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
    return to_http({AnswerCode::not_found,
                    "There is no such path; /api/worlds, /api/worlds/{id} and /api/query/{method} "
                    "are what there is."});
}

HttpResponse HttpRoutes::list_worlds() const {
    v1::ListWorldsResponse response;
    const Answer answer = worlds_.list({}, response);
    return answer.ok() ? json(200, response) : to_http(answer);
}

HttpResponse HttpRoutes::get_world(const std::string& world) const {
    v1::GetWorldRequest request;
    request.set_world(world);
    v1::GetWorldResponse response;
    const Answer answer = worlds_.get(request, response);
    return answer.ok() ? json(200, response) : to_http(answer);
}

HttpResponse HttpRoutes::create_world(const HttpRequest& request) const {
    v1::CreateWorldRequest message;
    if (const auto refused = read_json(message, request)) return *refused;
    v1::CreateWorldResponse response;
    const Answer answer = worlds_.create(message, response);
    return answer.ok() ? json(201, response) : to_http(answer);
}

HttpResponse HttpRoutes::query(const HttpRequest& request, std::string_view method) const {
    if (method == "CastRays") return ask(request, queries_, &QueryControl::cast_rays);
    if (method == "CastShapes") return ask(request, queries_, &QueryControl::cast_shapes);
    if (method == "Overlap") return ask(request, queries_, &QueryControl::overlap);
    if (method == "ClosestPoints") return ask(request, queries_, &QueryControl::closest_points);
    if (method == "Debug") return ask(request, queries_, &QueryControl::debug);
    return to_http({AnswerCode::not_found,
                    "There is no such query; CastRays, CastShapes, Overlap, ClosestPoints and "
                    "Debug are what there is."});
}

HttpResponse HttpRoutes::delete_world(const std::string& world) const {
    v1::DeleteWorldRequest request;
    request.set_world(world);
    v1::DeleteWorldResponse response;
    const Answer answer = worlds_.remove(request, response);
    return answer.ok() ? json(200, response) : to_http(answer);
}

}  // namespace jostle::server
