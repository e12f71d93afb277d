// SPDX-License-Identifier: MIT
//
// One HTTP connection: reads a request at a time, has HttpRoutes answer it, writes the answer;
// hands the socket over when the request asks for a WebSocket at /play. Lives on the gateway's
// thread; kept alive by its operation in flight.
#pragma once

#include <boost/asio/thread_pool.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>

#include "gateway/gateway_settings.h"
#include "gateway/http_routes.h"
#include "gateway/peer_bytes.h"

namespace jostle::server {

class HttpSession : public std::enable_shared_from_this<HttpSession> {
public:
    using Body = boost::beast::http::string_body;
    using Upgrade = std::function<void(boost::beast::tcp_stream, BeastRequest)>;

    struct Services {
        const HttpRoutes& routes;
        const GatewaySettings& settings;
        boost::asio::thread_pool& worker;  // for requests that take long
        Upgrade upgrade;                   // takes the socket of a WebSocket client
    };

    HttpSession(boost::asio::ip::tcp::socket socket, const Services& services);
    void start();
    void abort();

private:
    using Response = boost::beast::http::response<Body>;

    void read(std::chrono::seconds patience);
    void on_read(boost::beast::error_code error);
    void refuse(int status, std::string text);
    void answer_on_worker(HttpRequest request);
    void write(const HttpResponse& answer);
    void on_wrote(boost::beast::error_code error);

    boost::beast::tcp_stream stream_;
    const Services& services_;
    boost::beast::flat_buffer buffer_;
    std::optional<BeastRequestParser> parser_;
    Response response_;
    bool head_only_ = false;
};

}  // namespace jostle::server
