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

#include "gateway/http_handler.h"
#include "gateway/web_files.h"
#include "jostle/base/result.h"
#include "protocol/query_control.h"
#include "protocol/world_control.h"

namespace jostle::server {

struct RouteSettings {
    std::filesystem::path web_root;
    // Pages of these origins ("https://play.example.org") may use the server besides its own.
    std::vector<std::string> allowed_origins;
    std::function<bool()> is_draining;
    // What is wrong with the server; nothing: it is well.
    std::function<std::optional<std::string>()> trouble;
};

class HttpRoutes final : public HttpHandler {
public:
    // Both outlive the routes.
    HttpRoutes(WorldControl& worlds, const QueryControl& queries, RouteSettings settings);

    HttpResponse answer(const HttpRequest& request) const override;
    HttpWork work_of(const HttpRequest& request) const override;
    bool takes_large_body(const HttpRequest& request) const override;
    bool takes_players(const HttpRequest& request) const override;

    // A browser sends Origin with every WebSocket and every request that changes something. A page
    // from elsewhere must not use the visitor's browser to reach a server that only the visitor can
    // reach. No Origin: not a page.
    bool origin_is_allowed(const HttpRequest& request) const override;

private:
    HttpResponse answer_api(const HttpRequest& request, std::string_view path) const;
    HttpResponse list_worlds() const;
    HttpResponse get_world(const std::string& world) const;
    HttpResponse create_world(const HttpRequest& request) const;
    HttpResponse delete_world(const std::string& world) const;
    HttpResponse query(const HttpRequest& request, std::string_view method) const;

    WorldControl& worlds_;
    const QueryControl& queries_;
    RouteSettings settings_;
    WebFiles files_;
};

// {"code": "NOT_FOUND", "message": "..."} with the HTTP status that fits.
HttpResponse to_http(const Error& error);

}  // namespace jostle::server
