// SPDX-License-Identifier: MIT
//
// Interface of the request handler of an HTTP port. The port reads and frames requests and is
// independent of paths: the viewer port uses HttpRoutes, the admin port AdminRoutes.
#pragma once

#include <optional>
#include <string>

#include "server/http/http_message.h"

namespace jostle::server {

// The thread that handles a request: the port's own thread, or a worker for queries or for changes
// of worlds.
enum class HttpWork { immediate, query, mutation };

class HttpHandler {
public:
    virtual ~HttpHandler() = default;

    // Any thread; may block while a world is built or a profile is recorded.
    virtual HttpResponse handle(const HttpRequest& request) const = 0;
    virtual HttpWork work_of(const HttpRequest& request) const = 0;
    // Whether the request may have a body as large as a scene.
    virtual bool accepts_large_body(const HttpRequest& request) const = 0;
    // Whether a WebSocket upgrade with this request may become a play session.
    virtual bool accepts_players(const HttpRequest& request) const = 0;
    // Why a browser page may not send this request; empty: it is allowed, or not from a browser
    // page.
    virtual std::optional<std::string> cross_origin_refusal(const HttpRequest& request) const = 0;
};

}  // namespace jostle::server
