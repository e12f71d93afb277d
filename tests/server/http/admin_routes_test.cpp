// SPDX-License-Identifier: MIT
//
// The operator port: its responses, and over a socket, that profiles do not block other requests.
#include "server/http/admin_routes.h"

#include <gtest/gtest.h>

#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <nlohmann/json.hpp>
#include <thread>

#include "jostle/scenes/catalog.h"
#include "server/http/http_server.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
namespace asio = boost::asio;
using asio::ip::tcp;

class AdminRoutesTest : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(worlds.create("my arena", *scenes::find_scene("stack")).ok());
    }
    HttpResponse get(const std::string& target, const std::string& method = "GET",
                     const std::string& origin = {},
                     const std::string& host = "127.0.0.1:9464") const {
        HttpRequest request;
        request.method = method;
        request.target = target;
        request.origin = origin;
        request.host = host;
        request.address = "127.0.0.1";
        return routes.handle(request);
    }
    // Sends one request on its own connection; returns the complete response.
    static std::string fetch(int port, const std::string& target) {
        asio::io_context io;
        tcp::socket socket(io);
        socket.connect({asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(port)});
        asio::write(socket,
                    asio::buffer("GET " + target +
                                 " HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n"));
        std::string answer;
        boost::system::error_code ignored;
        asio::read(socket, asio::dynamic_buffer(answer), ignored);
        return answer;
    }

    Config config;
    SessionDirectory sessions{4};
    Metrics metrics{"test", {"solve"}};
    WorldDirectory worlds{{.metrics = &metrics}, 4};
    const std::unique_ptr<Authorizer> authorizer = *Authorizer::open(config);
    PlayContext context{.config = config,
                        .worlds = worlds,
                        .sessions = sessions,
                        .authorizer = *authorizer,
                        .metrics = &metrics};
    AdminControl control{context};
    std::optional<std::string> failure_reason;
    int refreshed = 0;
    AdminRoutes routes{
        control,
        metrics,
        {.allowed_hosts = {"ops.example.org"},
         .not_ready_reason =
             [this] {
                 return context.draining ? std::optional<std::string>("the server is shutting down")
                                         : std::nullopt;
             },
         .failure_reason = [this] { return failure_reason; },
         .refresh = [this] { refreshed++; }}};
};

TEST_F(AdminRoutesTest, returns_current_metrics_as_prometheus_text) {
    const HttpResponse response = get("/metrics");
    EXPECT_EQ(response.status, 200);
    EXPECT_EQ(response.content_type, "text/plain; version=0.0.4; charset=utf-8");
    EXPECT_NE(response.body.find("jostle_world_bodies{world=\"my arena\"}"), std::string::npos);
    EXPECT_EQ(refreshed, 1);
    worlds.remove("my arena");
    EXPECT_EQ(get("/metrics").body.find("my arena"), std::string::npos)
        << "the series of a removed world must be removed";
}

TEST_F(AdminRoutesTest, returns_health_status) {
    EXPECT_EQ(get("/healthz").status, 200);
    EXPECT_EQ(get("/readyz").status, 200);
    context.draining = true;
    EXPECT_EQ(get("/healthz").status, 200);
    EXPECT_EQ(get("/readyz").status, 503);
    context.draining = false;
    failure_reason = "a tick hangs";
    EXPECT_EQ(get("/healthz").body, "a tick hangs\n");
    EXPECT_EQ(get("/healthz").status, 503);
    EXPECT_EQ(get("/readyz").status, 503);
}

TEST_F(AdminRoutesTest, returns_profile_as_a_downloadable_trace) {
    const HttpResponse response = get("/debug/profile?world=my%20arena&seconds=1");
    ASSERT_EQ(response.status, 200) << response.body;
    const auto trace = nlohmann::json::parse(response.body);
    EXPECT_GT(trace.at("traceEvents").size(), 60u);
    ASSERT_EQ(response.headers.size(), 2u);
    EXPECT_EQ(response.headers[1].second, "attachment; filename=\"my_arena.trace.json\"");
}

TEST_F(AdminRoutesTest, returns_errors_for_invalid_requests) {
    for (const char* target :
         {"/debug/profile", "/debug/profile?world=my%20arena", "/debug/profile?seconds=1",
          "/debug/profile?world=my%20arena&seconds=x", "/debug/profile?world=my%20arena&seconds=1e",
          "/debug/profile?world=my%20arena&seconds=nan",
          "/debug/profile?world=my%20arena&seconds=31", "/debug/profile?world=&seconds=1"})
        EXPECT_EQ(get(target).status, 400) << target;
    EXPECT_EQ(get("/debug/profile?world=nowhere&seconds=1").status, 404);
    EXPECT_EQ(get("/nowhere").status, 404);
    EXPECT_EQ(get("/metrics", "POST").status, 405);
    const std::string profile = "/debug/profile?world=nowhere&seconds=1";
    EXPECT_EQ(get(profile, "GET", "http://elsewhere.example").status, 403)
        << "cross-origin requests must be rejected";
    EXPECT_EQ(get(profile, "GET", {}, "elsewhere.example:9464").status, 403) << "DNS rebinding";
    EXPECT_EQ(get(profile, "GET", {}, "ops.example.org").status, 404);
    EXPECT_EQ(get("/metrics", "GET", {}, "server:9464").status, 200)
        << "Prometheus sends no Origin";
    EXPECT_NE(get("/").body.find("/debug/profile?world=NAME"), std::string::npos);
}

// Two threads, of which one may run profiles. A scrape is served while profiles run.
TEST_F(AdminRoutesTest, profiles_do_not_block_scrapes_and_are_limited) {
    ASSERT_TRUE(worlds.create("b", *scenes::find_scene("stack")).ok());
    HttpServer http_server(context, routes,
                           {.host = "127.0.0.1",
                            .port = 0,
                            .metrics = &metrics.listener(Listener::admin),
                            .work_queue_max = 1,
                            .query_threads = 2});
    ASSERT_TRUE(http_server.start().ok());
    std::vector<std::thread> slow;
    std::atomic<int> served{0};
    for (const char* world : {"my%20arena", "b", "nowhere"}) {
        slow.emplace_back([&, world] {
            const std::string answer =
                fetch(http_server.port(), std::string("/debug/profile?seconds=2&world=") + world);
            if (answer.starts_with("HTTP/1.1 200")) served++;
        });
        std::this_thread::sleep_for(200ms);
    }
    const auto begun = Clock::now();
    EXPECT_TRUE(fetch(http_server.port(), "/metrics").starts_with("HTTP/1.1 200"));
    EXPECT_TRUE(fetch(http_server.port(), "/healthz").starts_with("HTTP/1.1 200"));
    EXPECT_LT(Clock::now() - begun, 1s);
    EXPECT_TRUE(
        fetch(http_server.port(), "/debug/profile?seconds=1&world=b").starts_with("HTTP/1.1 503"));
    EXPECT_EQ(metrics.listener(Listener::admin).refused(ConnectionRefusal::busy).Value(), 1);
    for (std::thread& thread : slow) thread.join();
    EXPECT_EQ(served, 2);
    EXPECT_TRUE(fetch(http_server.port(), "/play").starts_with("HTTP/1.1 404"))
        << "the admin port has no /play route";
    http_server.stop();
}

}  // namespace
}  // namespace jostle::server
