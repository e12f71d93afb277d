// SPDX-License-Identifier: MIT
#include "server/http/http_server.h"

#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/write.hpp>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "server/forwarding/trusted_proxies.h"
#include "server/http/http_routes.h"
#include "server/tls/certificate_store.h"
#include "tests/support/certificates.h"
#include "tests/support/temp_folder.h"

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

namespace {

// Responds with the address of the client.
class AddressHandler final : public HttpHandler {
public:
    HttpResponse handle(const HttpRequest& request) const override {
        return plain_text(200, "[" + request.address + "]");
    }
    HttpWork work_of(const HttpRequest&) const override { return HttpWork::immediate; }
    bool accepts_large_body(const HttpRequest&) const override { return false; }
    bool accepts_players(const HttpRequest&) const override { return true; }
    std::optional<std::string> cross_origin_refusal(const HttpRequest&) const override {
        return std::nullopt;
    }
    HttpHeaders cors_headers(std::string_view, std::string_view) const override {
        return {{"Vary", "Origin"}};
    }
};

const std::string last_request = "GET / HTTP/1.1\r\nHost: a\r\nConnection: close\r\n";

// The address in a response of AddressHandler.
std::string address_in(const std::string& response) {
    const std::size_t start = response.rfind('['), end = response.rfind(']');
    return start == std::string::npos ? response : response.substr(start + 1, end - start - 1);
}

// A header of PROXY protocol version 2: 203.0.113.9:4711 to 192.0.2.1:443.
const std::string proxy_header(
    "\r\n\r\n\0\r\nQUIT\n\x21\x11\0\x0c\xcb\0\x71\x09\xc0\0\x02\x01\x12\x67\x01\xbb", 28);

}  // namespace

TEST_F(HttpServerTest, believes_only_trusted_proxies_about_their_clients) {
    const AddressHandler handler;
    const TrustedProxies here = TrustedProxies::create({"127.0.0.1"}, {}).value(),
                         elsewhere = TrustedProxies::create({"10.0.0.0/8"}, {}).value();
    const std::string request =
        last_request + "X-Forwarded-For: 6.6.6.6, 203.0.113.9\r\nForwarded: for=7.7.7.7\r\n\r\n";
    for (const auto& [proxies, expected] :
         {std::pair(&here, "203.0.113.9"), std::pair(&elsewhere, "127.0.0.1")}) {
        HttpServer server(context, handler, {.port = 0, .proxies = proxies});
        ASSERT_TRUE(server.start().ok());
        EXPECT_EQ(address_in(response_of(server.port(), request)), expected);
        server.stop();
    }
}

TEST_F(HttpServerTest, reads_a_proxy_header_before_the_first_request) {
    const AddressHandler handler;
    const TrustedProxies proxies = TrustedProxies::create({"127.0.0.1"}, {}).value();
    HttpServer server(context, handler, {.port = 0, .proxies = &proxies, .proxy_protocol = true});
    ASSERT_TRUE(server.start().ok());
    // The client is no trusted proxy, so that its own headers do not count.
    EXPECT_EQ(address_in(response_of(
                  server.port(), proxy_header + last_request + "X-Forwarded-For: 6.6.6.6\r\n\r\n")),
              "203.0.113.9");
    EXPECT_EQ(response_of(server.port(), last_request + "\r\n"), "") << "the header is required";
    server.stop();

    const TrustedProxies elsewhere = TrustedProxies::create({"10.0.0.1"}, {}).value();
    HttpServer strict(context, handler, {.port = 0, .proxies = &elsewhere, .proxy_protocol = true});
    ASSERT_TRUE(strict.start().ok());
    EXPECT_EQ(address_in(response_of(strict.port(), last_request + "\r\n")), "127.0.0.1");
    EXPECT_TRUE(response_of(strict.port(), proxy_header + last_request + "\r\n")
                    .starts_with("HTTP/1.1 400 "))
        << "another sender cannot name a client";
    strict.stop();
}

// One connection of the proxy belongs to each of its clients, which have a limit of their own.
TEST_F(HttpServerTest, limits_the_clients_of_a_proxy_by_their_own_addresses) {
    const AddressHandler handler;
    const TrustedProxies proxies = TrustedProxies::create({"127.0.0.1"}, {}).value();
    HttpServer server(context, handler, {.port = 0, .proxies = &proxies, .per_address_max = 2});
    ASSERT_TRUE(server.start().ok());
    namespace asio = boost::asio;
    asio::io_context io;
    std::vector<asio::ip::tcp::socket> open;
    const auto play = [&](const char* client) {
        open.emplace_back(io);
        open.back().connect({asio::ip::address_v4::loopback(), server.port()});
        asio::write(
            open.back(),
            asio::buffer(std::string("GET /play HTTP/1.1\r\nHost: 127.0.0.1\r\n"
                                     "Upgrade: websocket\r\nConnection: Upgrade\r\n"
                                     "Sec-WebSocket-Version: 13\r\nX-Forwarded-For: ") +
                         client + "\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n"));
        std::string received;
        asio::read_until(open.back(), asio::dynamic_buffer(received), "\r\n\r\n");
        return received.substr(9, 3);
    };
    EXPECT_EQ(play("203.0.113.1"), "101");
    EXPECT_EQ(play("203.0.113.1"), "101");
    EXPECT_EQ(play("203.0.113.2"), "101");
    EXPECT_EQ(play("203.0.113.1"), "429");
    EXPECT_EQ(play("203.0.113.2"), "101");
    server.stop();
}

TEST_F(HttpServerTest, hints_at_the_right_protocol) {
    const AddressHandler handler;
    HttpServer server(context, handler, {.port = 0});
    ASSERT_TRUE(server.start().ok());
    EXPECT_EQ(response_of(server.port(), "\x16\x03\x01\x02"),
              std::string("\x15\x03\x01\0\x02\x02\x28", 7))
        << "a TLS alert";
    EXPECT_NE(response_of(server.port(), "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n").find("listen"),
              std::string::npos);
    EXPECT_TRUE(response_of(server.port(), "CONNECT a:80 HTTP/1.1\r\nHost: a\r\n\r\n")
                    .starts_with("HTTP/1.1 501 "));
    EXPECT_NE(response_of(server.port(), last_request + "\r\n").find("Vary: Origin"),
              std::string::npos);
    server.stop();

    const test::TempFolder folder;
    const auto leaf = test::make_certificate({});
    folder.write("key.pem", leaf.key_pem());
    folder.write("chain.pem", leaf.pem());
    const auto certificates =
        CertificateStore::open({.certificate = folder / "chain.pem", .key = folder / "key.pem"},
                               std::chrono::system_clock::now())
            .value();
    HttpServer secure(context, handler, {.port = 0, .certificates = certificates.get()});
    ASSERT_TRUE(secure.start().ok());
    const std::string plain = response_of(secure.port(), last_request + "\r\n");
    EXPECT_TRUE(plain.starts_with("HTTP/1.1 400 ")) << plain;
    EXPECT_NE(plain.find("https://"), std::string::npos) << plain;
    secure.stop();
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
