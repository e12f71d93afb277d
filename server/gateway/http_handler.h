// SPDX-License-Identifier: MIT
//
// Who answers the requests of an HTTP port. The port reads and frames them and knows no path: the
// viewer's port has HttpRoutes, the operators' has AdminRoutes.
#pragma once

#include "gateway/http_message.h"

namespace jostle::server {

// Who answers: the port's own thread, or one for what asks worlds or changes them.
enum class HttpWork { at_once, asks, changes };

class HttpHandler {
public:
    virtual ~HttpHandler() = default;

    // Any thread; may take as long as building a world, or a recording.
    virtual HttpResponse answer(const HttpRequest& request) const = 0;
    virtual HttpWork work_of(const HttpRequest& request) const = 0;
    // Whether the request may have a body as large as a scene.
    virtual bool takes_large_body(const HttpRequest& request) const = 0;
    // Whether a WebSocket client that comes with this request is to play.
    virtual bool takes_players(const HttpRequest& request) const = 0;
    // A browser says with many requests whose page sends them; false: not for that page.
    virtual bool origin_is_allowed(const HttpRequest& request) const = 0;
};

}  // namespace jostle::server
