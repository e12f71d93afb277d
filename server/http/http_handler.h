// SPDX-License-Identifier: MIT
//
// Who answers the requests of an HTTP port. The port reads and frames them and knows no path: the
// viewer's port has HttpRoutes, the operators' has AdminRoutes.
#pragma once

#include <optional>
#include <string>

#include "server/http/http_message.h"

namespace jostle::server {

// Who answers: the port's own thread, or one for what asks worlds or changes them.
enum class HttpWork { immediate, query, mutation };

class HttpHandler {
public:
    virtual ~HttpHandler() = default;

    // Any thread; may take as long as building a world, or a recording.
    virtual HttpResponse handle(const HttpRequest& request) const = 0;
    virtual HttpWork work_of(const HttpRequest& request) const = 0;
    // Whether the request may have a body as large as a scene.
    virtual bool accepts_large_body(const HttpRequest& request) const = 0;
    // Whether a WebSocket client that comes with this request is to play.
    virtual bool accepts_players(const HttpRequest& request) const = 0;
    // Why no page of a browser may send this request; nothing: it is none, or it may.
    virtual std::optional<std::string> cross_origin_refusal(const HttpRequest& request) const = 0;
};

}  // namespace jostle::server
