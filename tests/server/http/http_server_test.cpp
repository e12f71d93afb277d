// SPDX-License-Identifier: MIT
#include "server/http/http_server.h"

#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/write.hpp>
#include <thread>

#include "server/http/http_routes.h"

namespace jostle::server {

// The dependencies of an HttpServer, without worlds.
class HttpServerTest : public testing::Test {
protected:
    const Config config;
    SessionDirectory sessions{10};
    WorldDirectory worlds{{}, 1};
    const std::unique_ptr<Authorizer> authorizer = *Authorizer::open(config);
    PlayContext context{
        .config = config, .worlds = worlds, .sessions = sessions, .authorizer = *authorizer};
    WorldControl control{context};
    const QueryControl queries{context};
    const HttpRoutes routes{control,
                            queries,
                            {.web_root = ".",
                             .allowed_origins = {},
                             .not_ready_reason = [] { return std::optional<std::string>(); },
                             .failure_reason = [] { return std::nullopt; }}};
};

// Regression test: a timer that expired during stop() restarted itself and blocked the thread
// forever. Its period is 20 ms; these stops cover all phases of it.
TEST_F(HttpServerTest, stops_safely_during_housekeeping) {
    for (int i = 0; i < 60; i++) {
        HttpServer http_server(context, routes, {.host = "127.0.0.1", .port = 0});
        ASSERT_TRUE(http_server.start().ok());
        EXPECT_GT(http_server.port(), 0);
        std::this_thread::sleep_for(std::chrono::microseconds(19'000 + 50 * i));
        http_server.stop();
    }
}

namespace {

// The response to raw bytes, up to the end of the connection.
std::string response_of(std::uint16_t port, const std::string& request) {
    namespace asio = boost::asio;
    asio::io_context io;
    asio::ip::tcp::socket socket(io);
    socket.connect({asio::ip::address_v4::loopback(), port});
    asio::write(socket, asio::buffer(request));
    std::string response;
    boost::system::error_code closed;
    asio::read(socket, asio::dynamic_buffer(response), closed);
    return response;
}

}  // namespace

// A second request follows each ambiguous one; it must not be answered.
TEST_F(HttpServerTest, refuses_ambiguous_requests_and_closes_the_connection) {
    HttpServer http_server(context, routes, {.host = "127.0.0.1", .port = 0});
    ASSERT_TRUE(http_server.start().ok());
    const std::string start = "POST /api/worlds HTTP/1.1\r\n",
                      next = "GET /healthz HTTP/1.1\r\nHost: a\r\nConnection: close\r\n\r\n";
    for (const std::string headers :
         {"", "Host: a\r\nHost: b\r\n", "Host: a b\r\n",
          "Host: a\r\nContent-Length: 4\r\nTransfer-Encoding: chunked\r\n",
          "Host: a\r\nTransfer-Encoding: gzip\r\n", "Host: a\r\nTransfer-Encoding:\r\n chunked\r\n",
          "Host: a\r\nContent-Length: 4\r\nContent-Length: 4\r\n",
          "Host: a\r\nContent-Length : 4\r\n", "Host: a\r\nX-A: b\rc\r\n", "Host: a\nX-A: b\r\n"}) {
        const std::string response =
            response_of(http_server.port(), start + headers + "\r\n" + next);
        EXPECT_TRUE(response.starts_with("HTTP/1.1 400 ")) << headers << response;
        EXPECT_EQ(response.find("HTTP/1.1 ", 1), std::string::npos) << headers << response;
        EXPECT_NE(response.find("Connection: close"), std::string::npos) << headers << response;
    }
    const std::string good =
        response_of(http_server.port(), "GET /healthz HTTP/1.1\r\nHost: a\r\n\r\n" + next);
    EXPECT_NE(good.find("HTTP/1.1 200 ", 1), std::string::npos) << "two responses: " << good;
    http_server.stop();
}

// Regression test: the server destroyed the socket while Beast still waited for the client to close
// it. The address sanitizer finds the access; other builds only see that the server goes on.
TEST_F(HttpServerTest, disconnects_websocket_clients_that_stay_after_the_closing_handshake) {
    namespace asio = boost::asio;
    Config config;
    config.auth.anonymous_role = "player";
    SessionDirectory sessions(10);
    WorldDirectory worlds({}, 1);
    const std::unique_ptr<Authorizer> authorizer = *Authorizer::open(config);
    PlayContext context{
        .config = config, .worlds = worlds, .sessions = sessions, .authorizer = *authorizer};
    WorldControl control(context);
    const QueryControl queries(context);
    const HttpRoutes routes(control, queries,
                            {.web_root = ".",
                             .allowed_origins = {},
                             .not_ready_reason = [] { return std::optional<std::string>(); },
                             .failure_reason = [] { return std::nullopt; }});
    HttpServer http_server(context, routes, {.host = "127.0.0.1", .port = 0});
    ASSERT_TRUE(http_server.start().ok());

    asio::io_context io;
    asio::ip::tcp::socket socket(io);
    socket.connect({asio::ip::address_v4::loopback(), http_server.port()});
    asio::write(socket, asio::buffer(std::string(
                            "GET /play HTTP/1.1\r\nHost: 127.0.0.1\r\nUpgrade: websocket\r\n"
                            "Connection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
                            "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n")));
    std::string received;
    asio::read_until(socket, asio::dynamic_buffer(received), "\r\n\r\n");
    ASSERT_TRUE(received.starts_with("HTTP/1.1 101 ")) << received;
    // A text message, for which the server closes, and then the client's close frame.
    asio::write(socket, asio::buffer("\x81\x82\0\0\0\0hi", 8));
    asio::read_until(socket, asio::dynamic_buffer(received), "must be binary");
    asio::write(socket, asio::buffer("\x88\x82\0\0\0\0\x03\xf0", 8));
    // The server waits 5 s for the client to close the connection.
    std::this_thread::sleep_for(std::chrono::milliseconds(5500));
    boost::system::error_code closed;
    asio::read(socket, asio::dynamic_buffer(received), closed);
    EXPECT_TRUE(closed);
    const std::string healthy = response_of(
        http_server.port(), "GET /healthz HTTP/1.1\r\nHost: a\r\nConnection: close\r\n\r\n");
    EXPECT_TRUE(healthy.starts_with("HTTP/1.1 200 ")) << healthy;
    http_server.stop();
}

}  // namespace jostle::server
