// SPDX-License-Identifier: MIT
//
// Settings of an HTTP port: its address, and all limits per client.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>

#include "server/metrics/metrics.h"

namespace jostle::server {

class CertificateStore;
class TrustedProxies;

struct HttpServerSettings {
    std::string host = "127.0.0.1";
    std::uint16_t port = 8080;    // 0: any free port
    std::string flag = "--http";  // flag named in the error if the address is not available
    const ListenerMetrics* metrics = nullptr;        // null: no counting
    const CertificateStore* certificates = nullptr;  // null: no TLS; outlives the server
    bool require_certificates = false;               // require a certificate from every client
    const TrustedProxies* proxies = nullptr;         // null: none; outlive the server
    bool proxy_protocol = false;  // connections of trusted proxies begin with a PROXY header
    // Beyond the limit the connection that was idle longest is closed, so that new ones are
    // accepted.
    std::size_t connections_max = 1000;
    std::size_t per_address_max = 512;  // per IPv4 address or IPv6 /64
    std::size_t header_bytes_max = 8 * 1024;
    std::size_t body_bytes_max = 4 * 1024 * 1024;  // a scene or a query as JSON
    std::size_t small_body_bytes_max = 64 * 1024;  // for all other requests
    double bodies_bytes_max = 48e6;                // of all requests being received or handled
    std::size_t work_queue_max = 64;               // queued requests of each kind
    int query_threads = 1;
    std::size_t message_bytes_max = 64 * 1024;  // one ClientMessage
    // For receiving a complete request, and for sending a response.
    std::chrono::seconds request_timeout{10};
    std::chrono::seconds idle_timeout{30};  // between two requests on one connection
};

}  // namespace jostle::server
