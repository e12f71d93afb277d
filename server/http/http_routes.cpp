// SPDX-License-Identifier: MIT
#include "server/http/http_routes.h"

#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <charconv>
#include <string_view>

#include "jostle/base/check.h"
#include "jostle/scenes/scene_file.h"
#include "jostle/v1/admin.pb.h"
#include "jostle/v1/query.pb.h"
#include "jostle/v1/world.pb.h"
#include "server/auth/allowed_hosts.h"
#include "server/http/percent_decode.h"
#include "server/limits/account.h"
#include "server/session/peer.h"

namespace jostle::server {

namespace {

constexpr std::string_view worlds_path = "/api/worlds";
constexpr std::string_view query_path = "/api/query/", admin_path = "/api/admin/";
constexpr std::string_view resume_suffix = "/resume", join_suffix = "/join",
                           scene_suffix = "/scene";
constexpr std::string_view join_or_create_path = "/api/join-or-create";

HttpResponse json(int status, const google::protobuf::Message& message) {
    google::protobuf::util::JsonPrintOptions options;
    // a reader in a browser sees zeros instead of missing fields
    options.always_print_primitive_fields = true;
    std::string body;
    const auto written = google::protobuf::util::MessageToJsonString(message, &body, options);
    if (!written.ok()) {
        return to_http(Error{ErrorCode::internal, "cannot encode the response as JSON"});
    }
    return json_response(status, std::move(body));
}

HttpResponse method_not_allowed(std::string allowed) {
    HttpResponse response = plain_text(405, "This path supports " + allowed + ".\n");
    response.headers.emplace_back("Allow", std::move(allowed));
    return response;
}

constexpr std::string_view cross_origin_refused =
    "Pages from another origin may not use this server.";
// Headers that pages of another origin may send, and those that they may read.
constexpr const char* sendable_headers =
    "authorization, content-type, grpc-timeout, if-none-match, x-grpc-web, x-user-agent";
constexpr const char* readable_headers = "etag, retry-after, www-authenticate";
constexpr const char* supported_methods = "GET, HEAD, POST, DELETE, OPTIONS";
constexpr const char* preflight_max_age_seconds = "600";

// HTML forms can send text from any page without a preflight request, but not JSON.
std::optional<HttpResponse> wrong_content_type(const HttpRequest& request) {
    if (request.content_type.starts_with("application/json")) return std::nullopt;
    return plain_text(415, "Send the body as JSON, with Content-Type: application/json.\n");
}

// Decodes the JSON body of a request; returns an error response if it is invalid.
std::optional<HttpResponse> read_json(google::protobuf::Message& message,
                                      const HttpRequest& request) {
    if (auto refused = wrong_content_type(request)) return refused;
    const auto read = google::protobuf::util::JsonStringToMessage(request.body, &message);
    if (read.ok()) return std::nullopt;
    return to_http(Error{ErrorCode::invalid_argument,
                         "the body is not a " + message.GetDescriptor()->full_name() +
                             " as JSON: " + std::string(read.message())});
}

// The filter in the query of GET /api/worlds: tags=a,b&text=T&not_full=1&public=1&scene=S&owner=O
// &limit=N.
Status read_filter(std::string_view target, v1::ListWorldsRequest& message) {
    v1::WorldFilter& filter = *message.mutable_filter();
    const auto flag = [&](std::string_view name) -> Result<bool> {
        const auto value = query_field(target, name);
        if (!value || *value == "0") return false;
        if (*value == "1") return true;
        return invalid_argument(std::string(name) + " must be 0 or 1");
    };
    std::string tags = query_field(target, "tags").value_or("");
    for (std::size_t end = 0; !tags.empty(); tags.erase(0, end)) {
        end = std::min(tags.find(','), tags.size());
        filter.add_tags(tags.substr(0, end));
        end = std::min(end + 1, tags.size());
    }
    filter.set_text(query_field(target, "text").value_or(""));
    filter.set_scene(query_field(target, "scene").value_or(""));
    filter.set_owner(query_field(target, "owner").value_or(""));
    const Result<bool> not_full = flag("not_full"), is_public = flag("public");
    if (!not_full.ok()) return not_full.error();
    if (!is_public.ok()) return is_public.error();
    filter.set_not_full(*not_full);
    filter.set_is_public(*is_public);
    const auto limit = query_field(target, "limit");
    if (!limit) return {};
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(limit->data(), limit->data() + limit->size(), number);
    if (error != std::errc{} || end != limit->data() + limit->size())
        return invalid_argument("limit must be a number");
    message.set_limit(number);
    return {};
}

// Decodes a query, authorizes it, evaluates it and encodes the response.
template <class Request, class Response>
HttpResponse evaluate(const HttpRequest& request, const QueryControl& queries,
                      const std::function<Status(const std::string&)>& authorize_world,
                      Status (QueryControl::*method)(const Request&, Response&,
                                                     const CancellationCheck&) const) {
    Request message;
    if (const auto refused = read_json(message, request)) return *refused;
    if (Status s = authorize_world(message.world()); !s.ok()) return to_http(s.error());
    Response response;
    const Status status = (queries.*method)(message, response, QueryControl::always);
    return status.ok() ? json(200, response) : to_http(status.error());
}

}  // namespace

HttpRoutes::HttpRoutes(WorldControl& worlds, const QueryControl& queries, RouteSettings settings)
    : worlds_(worlds),
      queries_(queries),
      settings_(std::move(settings)),
      files_(settings_.web_root) {
    for (const std::string& text : settings_.allowed_origins)
        if (auto origin = parse_origin(text)) allowed_origins_.push_back(*std::move(origin));
}

bool HttpRoutes::is_grpc_web(const HttpRequest& request) const {
    return settings_.grpc_web && request.target.starts_with("/jostle.v1.");
}

HttpWork HttpRoutes::work_of(const HttpRequest& request) const {
    const std::string_view path = path_of(request.target);
    if (request.method == "OPTIONS") return HttpWork::immediate;
    if (is_grpc_web(request)) return settings_.grpc_web->work_of(request);
    if (path.starts_with(query_path) || path.starts_with(admin_path)) return HttpWork::query;
    if (path.starts_with(worlds_path) && path.ends_with(scene_suffix)) return HttpWork::mutation;
    const bool reads = request.method == "GET" || request.method == "HEAD";
    return reads || !path.starts_with("/api/") ? HttpWork::immediate : HttpWork::mutation;
}

bool HttpRoutes::accepts_players(const HttpRequest& request) const {
    return path_of(request.target) == "/play";
}

bool HttpRoutes::accepts_large_body(const HttpRequest& request) const {
    const std::string_view path = path_of(request.target);
    if (is_grpc_web(request)) return settings_.grpc_web->accepts_large_body(request);
    return request.method == "POST" &&
           (path == worlds_path || path == join_or_create_path || path.starts_with(query_path));
}

// The scheme of this server is unknown behind a proxy with TLS; a Host without a port is taken to
// be at the default port of the page's scheme.
bool HttpRoutes::origin_is_allowed(std::string_view origin, std::string_view host) const {
    if (origin.empty()) return true;
    const std::optional<Origin> page = parse_origin(origin);
    if (!page) return false;
    if (!host.empty() && parse_origin(page->scheme + "://" + std::string(host)) == page)
        return true;
    return std::ranges::find(allowed_origins_, *page) != allowed_origins_.end();
}

HttpHeaders HttpRoutes::cors_headers(std::string_view origin, std::string_view host) const {
    HttpHeaders headers;
    // Caches must not give the response for one origin to another.
    if (!allowed_origins_.empty()) headers.emplace_back("Vary", "Origin");
    if (origin.empty() || !origin_is_allowed(origin, host)) return headers;
    headers.emplace_back("Access-Control-Allow-Origin", std::string(origin));
    headers.emplace_back("Access-Control-Expose-Headers", readable_headers);
    return headers;
}

// A preflight request asks whether a page may send another request. No cookies are involved, so
// credentials are never allowed.
HttpResponse HttpRoutes::handle_options(const HttpRequest& request) const {
    if (!origin_is_allowed(request.origin, request.host))
        return plain_text(403, std::string(cross_origin_refused) + "\n");
    HttpResponse response{.status = 204};
    response.headers.emplace_back("Allow", supported_methods);
    if (request.origin.empty() || request.requested_method.empty()) return response;
    response.headers.emplace_back("Access-Control-Allow-Methods", supported_methods);
    response.headers.emplace_back("Access-Control-Allow-Headers", sendable_headers);
    response.headers.emplace_back("Access-Control-Max-Age", preflight_max_age_seconds);
    return response;
}

HttpResponse HttpRoutes::handle_grpc_web(const HttpRequest& request) const {
    if (!origin_is_allowed(request.origin, request.host))
        return plain_text(403, std::string(cross_origin_refused) + "\n");
    return settings_.grpc_web->handle(request);
}

std::optional<std::string> HttpRoutes::cross_origin_refusal(const HttpRequest& request) const {
    if (!host_is_allowed(request.host, settings_.allowed_hosts))
        return "The Host header does not name this server; the setting allowed_hosts lists its "
               "names.";
    if (!origin_is_allowed(request.origin, request.host)) return std::string(cross_origin_refused);
    return std::nullopt;
}

HttpResponse HttpRoutes::handle_health(std::string_view path) const {
    return health_response(path, settings_.failure_reason, settings_.not_ready_reason);
}

HttpResponse HttpRoutes::handle(const HttpRequest& request) const {
    const std::string_view path = path_of(request.target);
    // Probes may use any host name.
    if (path == "/healthz" || path == "/readyz") return handle_health(path);
    if (!host_is_allowed(request.host, settings_.allowed_hosts))
        return plain_text(403, *cross_origin_refusal(request) + "\n");
    if (request.method == "OPTIONS") return handle_options(request);
    if (is_grpc_web(request)) return handle_grpc_web(request);
    if (path == "/api" || path.starts_with("/api/")) return handle_api(request, path);
    if (path == "/play") {
        HttpResponse response = plain_text(426, "This path supports WebSocket clients only.\n");
        response.headers.emplace_back("Upgrade", "websocket");
        return response;
    }
    return files_.serve(request);
}

Result<HttpRoutes::RequestContext> HttpRoutes::authorize(const HttpRequest& request,
                                                         std::string_view path) const {
    const AccessRow* row = find_route(request.method, path);
    if (row == nullptr)
        return Error{ErrorCode::not_found,
                     "there is no such path; use /api/worlds, /api/worlds/{id}, "
                     "/api/join-or-create or /api/query/{method}"};
    const Result<std::string_view> bearer = parse_bearer(request.authorization);
    if (!bearer.ok()) return bearer.error();
    Result<Identity> who = worlds_.authorizer().identify(
        {.bearer = *bearer, .certificate = request.certificate, .address = request.address});
    if (!who.ok()) return who.error();
    RequestContext context{*std::move(who), row, request.address};
    if (row->scope == Scope::any_world || row->scope == Scope::own_world) return context;
    if (Status s = worlds_.authorizer().admit(context.who, {row->call, {}, context.address});
        !s.ok())
        return s.error();
    return context;
}

// The world of a query is known only after its body was read.
Status HttpRoutes::authorize_world(const RequestContext& context, const std::string& world) const {
    ASSERT(context.row);
    const std::shared_ptr<WorldHost> host = worlds_.find(world);
    const WorldTarget target = host ? world_target(*host) : WorldTarget{};
    return worlds_.authorizer().admit(context.who, {context.row->call, target, context.address});
}

HttpResponse HttpRoutes::handle_api(const HttpRequest& request, std::string_view path) const {
    const bool changes = request.method != "GET" && request.method != "HEAD";
    if (changes && !origin_is_allowed(request.origin, request.host))
        return plain_text(403, std::string(cross_origin_refused) + "\n");
    const bool is_query = path.starts_with(query_path), is_admin = path.starts_with(admin_path);
    const bool is_list = path == worlds_path;
    std::string world;
    if (path.starts_with("/api/worlds/")) {
        const std::optional<std::string> relative = relative_path_of(path);
        if (!relative) return to_http(Error{ErrorCode::invalid_argument, "the path is malformed"});
        world = relative->substr(worlds_path.size());  // without the first '/'
    }
    const bool is_resume = world.size() > resume_suffix.size() && world.ends_with(resume_suffix);
    const bool is_join = world.size() > join_suffix.size() && world.ends_with(join_suffix);
    if (is_resume) world.resize(world.size() - resume_suffix.size());
    if (is_join) world.resize(world.size() - join_suffix.size());
    const bool is_scene = world.size() > scene_suffix.size() && world.ends_with(scene_suffix);
    if (is_scene) world.resize(world.size() - scene_suffix.size());
    const bool is_world = !world.empty() && world.find('/') == std::string::npos;
    if (is_list && changes && request.method != "POST") return method_not_allowed("GET, POST");
    if ((is_join || path == join_or_create_path) && request.method != "POST")
        return method_not_allowed("POST");
    if (is_scene && changes) return method_not_allowed("GET");
    if (is_world && changes && request.method != (is_resume || is_join ? "POST" : "DELETE"))
        return method_not_allowed(is_resume ? "GET, POST" : "GET, DELETE");
    if ((is_query || is_admin) && request.method != "POST") return method_not_allowed("POST");
    const Result<RequestContext> context = authorize(request, path);
    if (!context.ok()) return to_http(context.error());
    if (is_list) return changes ? create_world(request, *context) : list_worlds(request, *context);
    if (path == join_or_create_path) return join_or_create(request, *context);
    if (is_query) return query(request, path.substr(query_path.size()), *context);
    if (is_admin) {
        if (!settings_.admin_api)
            return to_http(Error{ErrorCode::not_found, "the server has no /api/admin"});
        if (const auto refused = wrong_content_type(request)) return *refused;
        return settings_.admin_api->call(request, path.substr(admin_path.size()), context->who);
    }
    if (Status s = authorize_world(*context, world); !s.ok()) return to_http(s.error());
    if (is_resume && changes) return resume_world(world, *context);
    if (is_join) return join_world(request, world, *context);
    if (is_scene) return export_scene(world);
    return changes ? delete_world(world, *context) : get_world(world);
}

HttpResponse HttpRoutes::list_worlds(const HttpRequest& request,
                                     const RequestContext& context) const {
    v1::ListWorldsRequest message;
    if (Status s = read_filter(request.target, message); !s.ok()) return to_http(s.error());
    v1::ListWorldsResponse response;
    const Status status = worlds_.list(message, response, context.who);
    return status.ok() ? json(200, response) : to_http(status.error());
}

HttpResponse HttpRoutes::join_world(const HttpRequest& request, const std::string& world,
                                    const RequestContext& context) const {
    v1::JoinWorldRequest message;
    if (const auto refused = read_json(message, request)) return *refused;
    message.set_world(world);
    v1::JoinWorldResponse response;
    const Status status = worlds_.join(message, response, context.who, context.address);
    return status.ok() ? json(200, response) : to_http(status.error());
}

HttpResponse HttpRoutes::join_or_create(const HttpRequest& request,
                                        const RequestContext& context) const {
    v1::JoinOrCreateWorldRequest message;
    if (const auto refused = wrong_content_type(request)) return *refused;
    if (Status s = scenes::read_json_message(request.body, message); !s.ok())
        return to_http(s.error());
    v1::JoinOrCreateWorldResponse response;
    const Status status = worlds_.join_or_create(message, response, context.who, context.address);
    return status.ok() ? json(response.created() ? 201 : 200, response) : to_http(status.error());
}

HttpResponse HttpRoutes::get_world(const std::string& world) const {
    v1::GetWorldRequest request;
    request.set_world(world);
    v1::GetWorldResponse response;
    const Status status = worlds_.get(request, response);
    return status.ok() ? json(200, response) : to_http(status.error());
}

// A file of a scene contains no zeros that mean "default".
HttpResponse HttpRoutes::export_scene(const std::string& world) const {
    if (!settings_.admin_control)
        return to_http(Error{ErrorCode::not_found, "the server does not export worlds"});
    v1::ExportWorldRequest request;
    request.set_world(world);
    v1::ExportWorldResponse response;
    if (Status s = settings_.admin_control->export_world(request, response); !s.ok())
        return to_http(s.error());
    std::string body;
    if (!google::protobuf::util::MessageToJsonString(response, &body).ok())
        return to_http(Error{ErrorCode::internal, "cannot encode the scene as JSON"});
    return json_response(200, std::move(body));
}

HttpResponse HttpRoutes::create_world(const HttpRequest& request,
                                      const RequestContext& context) const {
    v1::CreateWorldRequest message;
    if (const auto refused = wrong_content_type(request)) return *refused;
    if (Status s = scenes::read_json_message(request.body, message); !s.ok())
        return to_http(s.error());
    v1::CreateWorldResponse response;
    Status status = worlds_.create(message, response, context.who, context.address);
    if (!status.ok() && message.has_scene())
        status = Error{status.error().code,
                       scenes::with_positions(request.body, "scene.", status.error().message)};
    const v1::WorldInfo& created = response.world();
    worlds_.authorizer().record(
        context.who,
        {context.row->call, {created.id(), created.name(), created.owner()}, context.address},
        status);
    return status.ok() ? json(201, response) : to_http(status.error());
}

HttpResponse HttpRoutes::query(const HttpRequest& request, std::string_view method,
                               const RequestContext& context) const {
    const QueryBudget::Spending spending(queries_.budget(),
                                         account_of(context.who.subject, context.address));
    if (!spending.status().ok()) return to_http(spending.status().error());
    const auto authorize_target = [&](const std::string& world) {
        return authorize_world(context, world);
    };
    if (method == "CastRays")
        return evaluate(request, queries_, authorize_target, &QueryControl::cast_rays);
    if (method == "CastShapes")
        return evaluate(request, queries_, authorize_target, &QueryControl::cast_shapes);
    if (method == "Overlap")
        return evaluate(request, queries_, authorize_target, &QueryControl::overlap);
    if (method == "ClosestPoints")
        return evaluate(request, queries_, authorize_target, &QueryControl::closest_points);
    if (method == "Debug")
        return evaluate(request, queries_, authorize_target, &QueryControl::debug);
    if (method == "Inspect")
        return evaluate(request, queries_, authorize_target, &QueryControl::inspect);
    return to_http(
        Error{ErrorCode::not_found,
              "there is no such query; use CastRays, CastShapes, Overlap, ClosestPoints, "
              "Debug or Inspect"});
}

HttpResponse HttpRoutes::resume_world(const std::string& world,
                                      const RequestContext& context) const {
    v1::GetWorldResponse response;
    const Status status = worlds_.resume(world, response);
    worlds_.authorizer().record(context.who, {context.row->call, {world, {}, {}}, context.address},
                                status);
    return status.ok() ? json(200, response) : to_http(status.error());
}

HttpResponse HttpRoutes::delete_world(const std::string& world,
                                      const RequestContext& context) const {
    v1::DeleteWorldRequest request;
    request.set_world(world);
    v1::DeleteWorldResponse response;
    const Status status = worlds_.remove(request, response);
    worlds_.authorizer().record(context.who, {context.row->call, {world, {}, {}}, context.address},
                                status);
    return status.ok() ? json(200, response) : to_http(status.error());
}

}  // namespace jostle::server
