// SPDX-License-Identifier: MIT
//
// One port for browsers: the viewer's files, the worlds as JSON, health, and at /play the same
// conversation as gRPC's over a WebSocket. Has a thread of its own for the sockets and
// two for requests that take long. Everything here is bounded: connections, header, body and
// message sizes, and how long a peer may be silent.
#pragma once

#include <cstdint>
#include <memory>

#include "jostle/base/result.h"
#include "server/http/http_handler.h"
#include "server/http/http_server_settings.h"
#include "server/session/client_session.h"

namespace jostle::server {

class HttpServer {
public:
    // Both outlive the gateway.
    HttpServer(PlayContext& context, const HttpHandler& routes, HttpServerSettings settings);
    ~HttpServer();

    // Binds and begins to serve. An error says which address and why.
    Status start();
    std::uint16_t port() const;  // the real one, after start()

    // Any thread: a world has a new frame, or the context began to drain.
    void wake();
    // Ends every connection and both threads.
    void stop();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace jostle::server
