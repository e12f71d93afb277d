// SPDX-License-Identifier: MIT
//
// `jostle-server --health` as the health check of a container runs it: a second process, and its
// exit status.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include "tests/system/server_process.h"

namespace jostle::test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::StartsWith;

// Probes the ports of a server. Its timeout is 3 s.
struct Probe {
    explicit Probe(const ServerProcess& server)
        : process({"--health", "--listen", server.grpc_address(), "--http",
                   "127.0.0.1:" + std::to_string(server.http_port())},
                  false),
          status(process.wait(3s)) {}
    ServerProcess process;
    std::optional<int> status;
};

TEST(HealthFlag, exits_with_0_when_healthy_and_1_when_hung_or_stopped) {
    ServerProcess server({"--scene", "stack", "--listen", "127.0.0.1:0", "--http", "127.0.0.1:0"});
    ASSERT_TRUE(server.is_running()) << server.log();
    {
        const Probe probe(server);
        EXPECT_EQ(probe.status, 0) << probe.process.log();
        EXPECT_THAT(probe.process.log(), StartsWith("healthy: gRPC on " + server.grpc_address()));
    }
    server.signal(SIGSTOP);
    {
        const Probe probe(server);
        EXPECT_EQ(probe.status, 1) << probe.process.log();
        EXPECT_THAT(probe.process.log(), StartsWith("not healthy: gRPC on "));
    }
    server.signal(SIGCONT);
    server.signal(SIGTERM);
    EXPECT_EQ(server.wait(9s), 0) << server.log();
    const Probe probe(server);
    EXPECT_EQ(probe.status, 1) << probe.process.log();
}

// The server was started with --insecure; the probe does not need the flag.
TEST(HealthFlag, probes_wildcard_listeners_without_an_exposure_check) {
    ServerProcess probe({"--health", "--listen", "0.0.0.0:1", "--http", "0.0.0.0:1"}, false);
    EXPECT_EQ(probe.wait(3s), 1);
    EXPECT_THAT(probe.log(), StartsWith("not healthy: gRPC on 127.0.0.1:1: "));
}

// The settings of the image come from the environment; the command line takes precedence.
TEST(HealthFlag, server_and_probe_read_the_same_environment) {
    setenv("JOSTLE_LISTEN", "nonsense", 1);
    ServerProcess wrong({"--health"}, false);
    EXPECT_EQ(wrong.wait(5s), 2);
    EXPECT_THAT(wrong.log(), HasSubstr("listen: \"nonsense\" is not HOST:PORT"));

    ServerProcess server({"--scene", "stack", "--listen", "127.0.0.1:0", "--http", "127.0.0.1:0"});
    EXPECT_TRUE(server.is_running()) << server.log();
    setenv("JOSTLE_LISTEN", server.grpc_address().c_str(), 1);
    setenv("JOSTLE_HTTP", ("127.0.0.1:" + std::to_string(server.http_port())).c_str(), 1);
    ServerProcess probe({"--health"}, false);
    EXPECT_EQ(probe.wait(3s), 0) << probe.log();
    unsetenv("JOSTLE_LISTEN");
    unsetenv("JOSTLE_HTTP");
}

}  // namespace
}  // namespace jostle::test
