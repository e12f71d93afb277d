// SPDX-License-Identifier: MIT
//
// What the gateway and its connections are told: where to listen, and every bound on a peer.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>

#include "server/metrics/metrics.h"

namespace jostle::server {

class CertificateStore;

struct HttpServerSettings {
    std::string host = "127.0.0.1";
    std::uint16_t port = 8080;                       // 0: any that is free
    std::string flag = "--http";                     // names the address when it cannot be had
    const ListenerMetrics* metrics = nullptr;        // null: nobody counts
    const CertificateStore* certificates = nullptr;  // null: without TLS; outlives the gateway
    bool require_certificates = false;               // of every client
    // More close the one that has been silent for longest, so that who comes is heard.
    std::size_t connections_max = 1000;
    std::size_t per_address_max = 512;  // of one IPv4 address or IPv6 /64
    std::size_t header_bytes_max = 8 * 1024;
    std::size_t body_bytes_max = 4 * 1024 * 1024;  // a scene as JSON, a question
    std::size_t small_body_bytes_max = 64 * 1024;  // of every other request
    double bodies_bytes_max = 48e6;                // of all that are being received or answered
    std::size_t work_queue_max = 64;               // requests that wait for a thread, of each kind
    int query_threads = 1;
    std::size_t message_bytes_max = 64 * 1024;  // one ClientMessage
    std::chrono::seconds request_timeout{
        10};  // for a whole request to come in, or an answer to go out
    std::chrono::seconds idle_timeout{30};  // between two requests on one connection
};

}  // namespace jostle::server
