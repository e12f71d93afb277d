// SPDX-License-Identifier: MIT
//
// An HTTP port for browsers: the viewer's files, the worlds as JSON, health, and play sessions over
// WebSocket at /play. Has its own thread for the sockets and worker threads for slow requests. All
// resources are bounded: connections, header, body and message sizes, and idle times.
#pragma once

#include <cstdint>
#include <memory>

#include "jostle/base/result.h"
#include "server/http/http_message.h"
#include "server/http/http_server_settings.h"
#include "server/session/client_session.h"

namespace jostle::server {

class HttpServer {
public:
    // Both must outlive the server.
    HttpServer(PlayContext& context, const HttpHandler& routes, HttpServerSettings settings);
    ~HttpServer();

    // Binds and starts serving. An error names the address and the reason.
    Status start();
    std::uint16_t port() const;  // the bound port, after start()

    // Any thread: a world has a new frame, or the context has started to drain.
    void wake();
    // Closes all connections and ends the threads.
    void stop();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace jostle::server
