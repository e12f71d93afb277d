// SPDX-License-Identifier: MIT
//
// Passive clients against a real server: both transports, as spectators, as players, and as slow
// readers.
#include "tools/load/passive_client_pool.h"

#include <gtest/gtest.h>

#include <atomic>

#include "bench/processes/server_process.h"
#include "tools/load/load_run.h"

namespace jostle::load {
namespace {

class PassiveClientPoolTest : public testing::Test {
protected:
    Report run(LoadOptions plan) {
        plan.target = "127.0.0.1:" + std::to_string(plan.transport == Transport::websocket
                                                        ? server_.http_port()
                                                        : server_.grpc_port());
        plan.ramp = plan.settle = 0.1;
        PassiveClientPool pool(plan, common::resolve(plan.target).value());
        const std::atomic<bool> stop{false};
        return run_load(plan, pool, std::nullopt, stop);
    }

    bench::ServerProcess server_{JOSTLE_SERVER,
                                 {"--scene", "sandbox", "--listen", "127.0.0.1:0", "--http",
                                  "127.0.0.1:0", "--log-level", "warn"},
                                 true};
};

}  // namespace

TEST_F(PassiveClientPoolTest, ten_passive_clients_receive_every_snapshot_over_both_transports) {
    for (const Transport transport : {Transport::grpc, Transport::websocket}) {
        const Report report =
            run({.clients = 10, .seconds = 0.4, .transport = transport, .decode_ratio = 0.5});
        EXPECT_EQ(report.connected, 10);
        EXPECT_EQ(report.errors, 0u) << report.last_error;
        EXPECT_GT(report.snapshots_per_second_per_client, 30) << "60 on an idle machine";
        EXPECT_NEAR(report.decoded_share, 0.5, 0.1);
        EXPECT_EQ(report.age_ms.count, report.snapshots);
    }
}

TEST_F(PassiveClientPoolTest, scripted_passive_clients_receive_input_results) {
    const Report report = run({.clients = 6,
                               .seconds = 0.6,
                               .script = bot::parse_script("push period=0.2\n", "test").value()});
    EXPECT_EQ(report.errors, 0u) << report.last_error;
    EXPECT_GT(report.inputs_accepted, 5u);
    EXPECT_GT(report.result_delay_ms.count, 5u);
    EXPECT_GT(report.effect_delay_ms.count, 5u);
}

TEST_F(PassiveClientPoolTest, passive_clients_with_an_area_of_interest_decode_their_snapshots) {
    const Report report = run(
        {.clients = 5, .seconds = 0.5, .interest_radius = 6, .max_kbps = 200, .decode_ratio = 1});
    EXPECT_EQ(report.errors, 0u) << report.last_error;
    EXPECT_EQ(report.connected, 5);
    EXPECT_GT(report.decoded_share, 0.9);
    EXPECT_LT(report.kbit_per_second_per_client, 210);
}

TEST_F(PassiveClientPoolTest, limits_reading_to_the_configured_rate) {
    for (const Transport transport : {Transport::grpc, Transport::websocket}) {
        const Report report =
            run({.clients = 2, .seconds = 0.6, .transport = transport, .read_rate = 40});
        EXPECT_EQ(report.errors, 0u) << report.last_error;
        EXPECT_LE(report.messages_per_second_per_client, 42);
        EXPECT_GT(report.messages_per_second_per_client, 20) << "38 and more on an idle machine";
    }
}

}  // namespace jostle::load
