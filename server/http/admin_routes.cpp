// SPDX-License-Identifier: MIT
#include "server/http/admin_routes.h"

#include <charconv>

#include "jostle/v1/admin.pb.h"
#include "server/auth/access_table.h"
#include "server/auth/allowed_hosts.h"
#include "server/http/http_routes.h"
#include "server/http/percent_decode.h"
#include "server/metrics/metrics_text.h"
#include "server/session/peer.h"

namespace jostle::server {

namespace {

constexpr std::string_view profile_path = "/debug/profile";
constexpr std::string_view index =
    "Admin port of jostle-server:\n"
    "  /metrics                              metrics for Prometheus\n"
    "  /healthz, /readyz                     health: 200 or 503\n"
    "  /debug/profile?world=NAME&seconds=N   tick profile for ui.perfetto.dev\n";

// Parses "5" or "2.5"; rejects any other text.
std::optional<double> number_of(const std::string& text) {
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

// File name for browsers and curl -OJ; a world name may contain any character.
std::string file_name_of(const std::string& world) {
    std::string name;
    for (const char c : world) {
        const bool plain =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
        name += plain ? c : '_';
    }
    return name + ".trace.json";
}

}  // namespace

HttpWork AdminRoutes::work_of(const HttpRequest& request) const {
    return path_of(request.target) == profile_path ? HttpWork::query : HttpWork::immediate;
}

HttpResponse AdminRoutes::handle(const HttpRequest& request) const {
    if (request.method != "GET" && request.method != "HEAD") {
        HttpResponse refused = plain_text(405, "This port supports GET only.\n");
        refused.headers.emplace_back("Allow", "GET, HEAD");
        return refused;
    }
    const std::string_view path = path_of(request.target);
    if (path == "/") return plain_text(200, std::string(index));
    if (path == "/metrics") return metrics();
    if (path == "/healthz" || path == "/readyz") return health(path);
    if (path == profile_path) {
        if (const auto refusal = cross_origin_refusal(request))
            return plain_text(403, *refusal + "\n");
        return profile(request);
    }
    return plain_text(404, "There is no such path; / lists the paths.\n");
}

// Not checked for metrics and health: Prometheus and probes may use any host name, and these paths
// identify no client.
std::optional<std::string> AdminRoutes::cross_origin_refusal(const HttpRequest& request) const {
    if (!request.origin.empty()) return "Browser pages may not use the admin port.";
    if (!host_is_allowed(request.host, settings_.allowed_hosts))
        return "The Host header does not name this server; the setting allowed_hosts lists its "
               "names.";
    return std::nullopt;
}

// Requires the admin role, according to the access table.
Status AdminRoutes::authorize(const HttpRequest& request, const std::string& world) const {
    const AccessRow* const row = find_route(request.method, path_of(request.target));
    if (!row) return Error{ErrorCode::not_found, "there is no such path"};
    const Result<std::string_view> bearer = parse_bearer(request.authorization);
    if (!bearer.ok()) return bearer.error();
    Authorizer& authorizer = control_.authorizer();
    const Result<Identity> who = authorizer.identify(
        {.bearer = *bearer, .certificate = request.certificate, .address = request.address});
    if (!who.ok()) return who.error();
    const std::shared_ptr<WorldHost> host = control_.find(world);
    return authorizer.admit(
        *who, {row->call, host ? world_target(*host) : WorldTarget{}, request.address});
}

HttpResponse AdminRoutes::health(std::string_view path) const {
    return health_response(path, settings_.failure_reason, settings_.not_ready_reason);
}

HttpResponse AdminRoutes::metrics() const {
    const std::lock_guard lock(metrics_mutex_);
    if (settings_.refresh) settings_.refresh();
    HttpResponse response = plain_text(200, metrics_text(metrics_));
    response.content_type = metrics_content_type;
    return response;
}

HttpResponse AdminRoutes::profile(const HttpRequest& request) const {
    const auto world = query_field(request.target, "world");
    const auto duration = query_field(request.target, "seconds");
    const auto seconds = duration ? number_of(*duration) : std::nullopt;
    if (!world || !seconds)
        return to_http(
            Error{ErrorCode::invalid_argument,
                  "world and seconds are required: /debug/profile?world=NAME&seconds=5"});
    if (Status s = authorize(request, *world); !s.ok()) return to_http(s.error());
    v1::ProfileRequest message;
    message.set_world(*world);
    message.set_seconds(*seconds);
    v1::ProfileResponse profile;
    if (Status s = control_.profile(message, profile); !s.ok()) return to_http(s.error());
    HttpResponse response = plain_text(200, profile.trace());
    response.content_type = "application/json";
    response.headers.emplace_back("Content-Disposition",
                                  "attachment; filename=\"" + file_name_of(*world) + "\"");
    return response;
}

}  // namespace jostle::server
