// SPDX-License-Identifier: MIT
//
// The paths of the viewer port: health, worlds and queries as JSON, and the viewer's files.
// Independent of sockets. Any thread may call handle(), which may block while a world is built.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "jostle/base/result.h"
#include "server/config/origin.h"
#include "server/http/admin_api.h"
#include "server/http/http_error.h"
#include "server/http/http_message.h"
#include "server/http/web_files.h"
#include "server/services/admin_control.h"
#include "server/services/query_control.h"
#include "server/services/world_control.h"

namespace jostle::server {

struct RouteSettings {
    std::filesystem::path web_root;
    // Origins ("https://play.example.org") whose pages may use the server, in addition to its own.
    std::vector<std::string> allowed_origins;
    // Own host names in addition to IP addresses and localhost (auth/allowed_hosts.h).
    std::vector<std::string> allowed_hosts = {"*"};
    std::function<std::optional<std::string>()> not_ready_reason;  // empty: ready
    // The fault of the server; empty: healthy.
    std::function<std::optional<std::string>()> failure_reason;
    const HttpHandler* grpc_web = nullptr;  // null: no gRPC-Web; outlives the routes
    const AdminApi* admin_api = nullptr;    // null: no /api/admin; outlives the routes
    AdminControl* admin_control = nullptr;  // null: no export of scenes; outlives the routes
};

class HttpRoutes final : public HttpHandler {
public:
    // Both must outlive the routes.
    HttpRoutes(WorldControl& worlds, const QueryControl& queries, RouteSettings settings);

    HttpResponse handle(const HttpRequest& request) const override;
    HttpWork work_of(const HttpRequest& request) const override;
    bool accepts_large_body(const HttpRequest& request) const override;
    bool accepts_players(const HttpRequest& request) const override;

    // Rejects pages that use their visitor's browser to reach a server that only the visitor can
    // reach: pages from another origin, and pages whose host name resolves to this server (DNS
    // rebinding). Returns the reason; empty: allowed.
    std::optional<std::string> cross_origin_refusal(const HttpRequest& request) const override;
    HttpHeaders cors_headers(std::string_view origin, std::string_view host) const override;

private:
    // The caller, and the row of the access table that the request matches.
    struct RequestContext {
        Identity who;
        const AccessRow* row = nullptr;
        const std::string& address;
    };

    bool origin_is_allowed(std::string_view origin, std::string_view host) const;
    bool is_grpc_web(const HttpRequest& request) const;
    HttpResponse handle_options(const HttpRequest& request) const;
    HttpResponse handle_grpc_web(const HttpRequest& request) const;
    HttpResponse handle_health(std::string_view path) const;
    HttpResponse handle_api(const HttpRequest& request, std::string_view path) const;
    Result<RequestContext> authorize(const HttpRequest& request, std::string_view path) const;
    Status authorize_world(const RequestContext& context, const std::string& world) const;
    HttpResponse list_worlds(const HttpRequest& request, const RequestContext& context) const;
    HttpResponse join_world(const HttpRequest& request, const std::string& world,
                            const RequestContext& context) const;
    HttpResponse join_or_create(const HttpRequest& request, const RequestContext& context) const;
    HttpResponse get_world(const std::string& world) const;
    HttpResponse export_scene(const std::string& world) const;
    HttpResponse create_world(const HttpRequest& request, const RequestContext& context) const;
    HttpResponse resume_world(const std::string& world, const RequestContext& context) const;
    HttpResponse delete_world(const std::string& world, const RequestContext& context) const;
    HttpResponse query(const HttpRequest& request, std::string_view method,
                       const RequestContext& context) const;

    WorldControl& worlds_;
    const QueryControl& queries_;
    RouteSettings settings_;
    std::vector<Origin> allowed_origins_;
    WebFiles files_;
};

}  // namespace jostle::server
