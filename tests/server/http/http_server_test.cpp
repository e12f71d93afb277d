// SPDX-License-Identifier: MIT
#include "server/http/http_server.h"

#include <gtest/gtest.h>

#include <thread>

#include "server/http/http_routes.h"

namespace jostle::server {

// Regression test: a timer that expired during stop() restarted itself and blocked the thread
// forever. Its period is 20 ms; these stops cover all phases of it.
TEST(HttpServerTest, stops_safely_during_housekeeping) {
    const Config config;
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
    for (int i = 0; i < 60; i++) {
        HttpServer http_server(context, routes, {.host = "127.0.0.1", .port = 0});
        ASSERT_TRUE(http_server.start().ok());
        EXPECT_GT(http_server.port(), 0);
        std::this_thread::sleep_for(std::chrono::microseconds(19'000 + 50 * i));
        http_server.stop();
    }
}

}  // namespace jostle::server
