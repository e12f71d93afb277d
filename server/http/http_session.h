// SPDX-License-Identifier: MIT
//
// One HTTP connection: reads one request at a time, passes it to its handler and writes the
// response; passes the socket on if the request is a WebSocket upgrade at /play. The header is
// checked before the body is read, because the memory for all bodies is limited. Runs on the
// server's thread; owned by its pending operation.
#pragma once

#include <array>
#include <boost/beast/core/flat_buffer.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "server/forwarding/proxy_protocol.h"
#include "server/http/beast_request.h"
#include "server/http/http_message.h"
#include "server/http/http_server_settings.h"
#include "server/http/socket_stream.h"
#include "server/util/clock.h"
#include "server/util/token_bucket.h"
#include "server/util/work_pool.h"
#include "server/util/wrong_protocol.h"

namespace jostle::server {

class HttpSession : public std::enable_shared_from_this<HttpSession> {
public:
    using Body = boost::beast::http::string_body;
    using Upgrade = std::function<void(SocketStream, BeastRequest, SocketPeer)>;

    struct Services {
        const HttpHandler& routes;
        const HttpServerSettings& settings;
        WorkPool& query_pool;     // for queries
        WorkPool& mutation_pool;  // for changes of worlds
        double& body_bytes;       // total of all sessions
        Upgrade upgrade;          // takes ownership of the socket of a WebSocket client
        // Whether the address of a client that a proxy named has fewer than the maximum of
        // connections.
        std::function<bool(const std::string& address)> has_room_for;
        TokenBucket& hint_log;  // limits log lines about clients of a wrong protocol
    };

    HttpSession(SocketStream stream, const Services& services);
    ~HttpSession();
    void start();
    void abort();
    // Start of the wait for a request; empty while a request is received or handled.
    std::optional<Clock::time_point> idle_since() const { return idle_since_; }
    // Of the connection: a proxy, unless it named its client in a PROXY header.
    const std::string& address() const { return address_; }

private:
    using Response = boost::beast::http::response<Body>;

    void read_proxy_header();
    void on_proxy_header(boost::beast::error_code error, std::size_t bytes);
    void secure();
    void on_first_bytes(boost::beast::error_code error, std::size_t bytes);
    void reply_to_wrong_protocol(FirstBytes protocol, std::string_view hint);
    void read(std::chrono::seconds timeout);
    void parse_header();
    void on_header(boost::beast::error_code error);
    void read_body();
    void on_body(boost::beast::error_code error);
    bool failed(boost::beast::error_code error);
    bool reserve_body(std::size_t bytes);
    void release_body();
    void handle_request();
    std::string client_address() const;
    HttpRequest request_of_peer() const;
    void refuse(int status, std::string text);
    void handle_on(WorkPool& pool, HttpRequest request);
    void write(const HttpResponse& response);
    void on_wrote(boost::beast::error_code error);

    SocketStream stream_;
    const Services& services_;
    boost::beast::flat_buffer buffer_;
    std::optional<BeastRequestParser> parser_;
    Response response_;
    bool head_only_ = false, closing_ = false;
    double reserved_ = 0;  // bytes of this request's body
    std::optional<Clock::time_point> idle_since_;
    std::string address_, certificate_;
    std::string peer_;                               // "192.0.2.7:4711"
    std::optional<ProxyHeaderReader> proxy_header_;  // until it is complete
    std::array<std::uint8_t, 512> first_bytes_{};    // before HTTP
    std::string raw_reply_;
};

}  // namespace jostle::server
