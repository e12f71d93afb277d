// SPDX-License-Identifier: MIT
//
// Who answers the requests of an HTTP port. The port reads and frames them and knows no path: the
// viewer's port has HttpRoutes, the operators' has AdminRoutes.
#pragma once

#include "gateway/http_message.h"

namespace jostle::server {

class HttpHandler {
public:
    virtual ~HttpHandler() = default;

    // Any thread.
    virtual HttpResponse answer(const HttpRequest& request) const = 0;
    // It may take longer than the port's own thread can wait: a worker is asked instead.
    virtual bool may_take_long(const HttpRequest& request) const = 0;
    // Whether a WebSocket client that comes with this request is to play.
    virtual bool takes_players(const HttpRequest& request) const = 0;
    // A browser says with many requests whose page sends them; false: not for that page.
    virtual bool origin_is_allowed(const HttpRequest& request) const = 0;
};

}  // namespace jostle::server
