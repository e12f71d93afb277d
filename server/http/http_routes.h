// SPDX-License-Identifier: MIT
//
// What each HTTP path answers: health, worlds and queries as JSON, the viewer's files. Knows
// nothing of sockets. Any thread may call answer(), which may take as long as building a world.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "jostle/base/result.h"
#include "server/http/http_handler.h"
#include "server/http/web_files.h"
#include "server/services/query_control.h"
#include "server/services/world_control.h"

namespace jostle::server {

struct RouteSettings {
    std::filesystem::path web_root;
    // Pages of these origins ("https://play.example.org") may use the server besides its own.
    std::vector<std::string> allowed_origins;
    // Own names besides IP addresses and localhost (identity/allowed_hosts.h).
    std::vector<std::string> allowed_hosts = {"*"};
    std::function<std::optional<std::string>()> not_ready_reason;  // nothing: it is
    // What is wrong with the server; nothing: it is well.
    std::function<std::optional<std::string>()> failure_reason;
};

class HttpRoutes final : public HttpHandler {
public:
    // Both outlive the routes.
    HttpRoutes(WorldControl& worlds, const QueryControl& queries, RouteSettings settings);

    HttpResponse handle(const HttpRequest& request) const override;
    HttpWork work_of(const HttpRequest& request) const override;
    bool accepts_large_body(const HttpRequest& request) const override;
    bool accepts_players(const HttpRequest& request) const override;

    // Against pages that use their visitor's browser to reach a server that only the visitor can
    // reach: they come from another origin, or made their own name point here. Why this request is
    // refused; nothing: it is no such page.
    std::optional<std::string> cross_origin_refusal(const HttpRequest& request) const override;

private:
    // Who asks, for which row of the access table.
    struct RequestContext {
        Identity who;
        const AccessRow* row = nullptr;
        const std::string& address;
    };

    bool origin_is_allowed(const HttpRequest& request) const;
    HttpResponse handle_health(std::string_view path) const;
    HttpResponse handle_api(const HttpRequest& request, std::string_view path) const;
    Result<RequestContext> authorize(const HttpRequest& request, std::string_view path) const;
    Status authorize_world(const RequestContext& context, const std::string& world) const;
    HttpResponse list_worlds() const;
    HttpResponse get_world(const std::string& world) const;
    HttpResponse create_world(const HttpRequest& request, const RequestContext& context) const;
    HttpResponse delete_world(const std::string& world, const RequestContext& context) const;
    HttpResponse query(const HttpRequest& request, std::string_view method,
                       const RequestContext& context) const;

    WorldControl& worlds_;
    const QueryControl& queries_;
    RouteSettings settings_;
    WebFiles files_;
};

// {"code": "NOT_FOUND", "message": "..."} with the HTTP status that fits.
HttpResponse to_http(const Error& error);

}  // namespace jostle::server
