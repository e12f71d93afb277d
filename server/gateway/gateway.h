// SPDX-License-Identifier: MIT
//
// One port for browsers: the viewer's files, the worlds as JSON, health, and at /play the same
// conversation as gRPC's over a WebSocket. Has a thread of its own for the sockets and one for
// requests that take long. Everything here is bounded: connections, header, body and message sizes,
// and how long a peer may be silent.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "gateway/http_routes.h"
#include "jostle/base/result.h"
#include "protocol/client_link.h"

namespace jostle::server {

struct GatewaySettings {
    std::string host = "127.0.0.1";
    std::uint16_t port = 8080;  // 0: any that is free
    std::size_t connections_max = 1000;
    std::size_t header_bytes_max = 8 * 1024;
    std::size_t body_bytes_max = 4 * 1024 * 1024;  // a scene as JSON
    std::size_t message_bytes_max = 64 * 1024;     // one ClientMessage
    std::chrono::seconds request_timeout{
        10};  // for a whole request to come in, or an answer to go out
    std::chrono::seconds idle_timeout{30};  // between two requests on one connection
};

class Gateway {
public:
    // Both outlive the gateway.
    Gateway(PlayContext& context, const HttpRoutes& routes, GatewaySettings settings);
    ~Gateway();

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
