// SPDX-License-Identifier: MIT
//
// What the gateway and its connections are told: where to listen, and every bound on a peer.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>

#include "telemetry/metrics.h"

namespace jostle::server {

struct GatewaySettings {
    std::string host = "127.0.0.1";
    std::uint16_t port = 8080;                 // 0: any that is free
    std::string flag = "--http";               // which address to change when the port is taken
    const ListenerMetrics* metrics = nullptr;  // null: nobody counts
    std::size_t connections_max = 1000;
    std::size_t header_bytes_max = 8 * 1024;
    std::size_t body_bytes_max = 4 * 1024 * 1024;  // a scene as JSON
    std::size_t message_bytes_max = 64 * 1024;     // one ClientMessage
    int slow_requests_max = 64;                    // on the worker or waiting for it
    int workers = 1;                               // threads for those
    std::chrono::seconds request_timeout{
        10};  // for a whole request to come in, or an answer to go out
    std::chrono::seconds idle_timeout{30};  // between two requests on one connection
};

}  // namespace jostle::server
