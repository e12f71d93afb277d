// SPDX-License-Identifier: MIT
//
// What conversations add to the metrics, told by a client that plays.
#include "server/session/session_metrics.h"

#include <gtest/gtest.h>

#include <thread>

#include "jostle/scenes/catalog.h"
#include "jostle/v1/play.pb.h"
#include "server/session/client_session.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

class SessionMetricsTest : public testing::Test {
protected:
    void SetUp() override {
        ASSERT_TRUE(worlds.create("arena", *scenes::find_scene("stack")).ok());
    }

    Peer peer() {
        return {.name = "test",
                .address = "127.0.0.1",
                .call = "jostle.v1.PlayService/Play",
                .who = authorizer->identify({.address = "127.0.0.1"})};
    }
    static void hello(ClientSession& session) {
        v1::ClientMessage message;
        message.mutable_hello()->set_protocol(1);
        session.receive(message.SerializeAsString(), Clock::now());
    }
    // Reads for so long; the newest frame and the bytes of all snapshots.
    std::pair<std::uint32_t, std::size_t> listen(ClientSession& session, Clock::duration time,
                                                 bool acknowledge) {
        std::uint32_t frame = 0;
        std::size_t bytes = 0;
        for (const auto end = Clock::now() + time; Clock::now() < end;
             std::this_thread::sleep_for(5ms)) {
            while (const auto message = session.take_message(Clock::now())) {
                v1::ServerMessage parsed;
                parsed.ParseFromString(message->header + (message->shared ? *message->shared : ""));
                if (!parsed.has_snapshot()) continue;
                frame = parsed.snapshot().frame();
                bytes += message->size();
                snapshots++;
            }
            if (!acknowledge || frame == 0) continue;
            v1::ClientMessage ack;
            ack.mutable_ack()->set_frame(frame);
            session.receive(ack.SerializeAsString(), Clock::now());
        }
        return {frame, bytes};
    }
    double clients() const {
        return worlds.find("arena")->tick_metrics().metrics()->clients().Value();
    }

    Config config;
    SessionDirectory sessions{4};
    Metrics metrics{"test", {}};
    WorldDirectory worlds{{.metrics = &metrics}, 4};
    const std::unique_ptr<Authorizer> authorizer = *Authorizer::open(config);
    PlayContext context{.config = config,
                        .worlds = worlds,
                        .sessions = sessions,
                        .authorizer = *authorizer,
                        .metrics = &metrics};
    int snapshots = 0;
};

TEST_F(SessionMetricsTest, counts_snapshots_clients_and_inputs) {
    {
        ClientSession session(context, peer(), Clock::now());
        EXPECT_EQ(clients(), 0);
        hello(session);
        EXPECT_EQ(clients(), 1);
        const auto [frame, bytes] = listen(session, 300ms, true);
        EXPECT_GT(snapshots, 3);
        EXPECT_EQ(metrics.snapshots_sent.Value(), snapshots);
        EXPECT_EQ(metrics.snapshot_bytes.Value(), static_cast<double>(bytes));
        v1::ClientMessage message;
        message.mutable_input()->set_first_sequence(1);
        message.mutable_input()->add_inputs()->mutable_delete_()->set_entity(999);
        message.mutable_input()->add_inputs()->mutable_release();
        v1::Input& huge = *message.mutable_input()->add_inputs();
        huge.mutable_spawn()->mutable_shape()->mutable_sphere()->set_radius(1000);
        session.receive(message.SerializeAsString(), Clock::now());
        listen(session, 200ms, true);
        EXPECT_EQ(metrics.inputs[InputOutcome::not_found].Value(), 1);
        EXPECT_EQ(metrics.inputs[InputOutcome::applied].Value(), 1);
        EXPECT_EQ(metrics.inputs[InputOutcome::invalid].Value(), 1);
        EXPECT_EQ(metrics.inputs[InputOutcome::limit].Value(), 0);
        const auto sights = context.connected_clients.status(Clock::now());
        ASSERT_EQ(sights.size(), 1u);
        EXPECT_GT(sights[0].round_trip_ms, 0);
    }
    EXPECT_GT(metrics.sent_bytes[TrafficKind::poses].Value(), 0);
    EXPECT_GT(metrics.sent_bytes[TrafficKind::entities].Value(), 0);
    EXPECT_GT(metrics.sent_bytes[TrafficKind::statistics].Value(), 0);
    EXPECT_GT(metrics.sent_bytes[TrafficKind::replies].Value(), 0) << "the welcome";
    EXPECT_EQ(metrics.sent_bytes[TrafficKind::events].Value(), 0) << "not requested";
    EXPECT_EQ(clients(), 0);
    EXPECT_TRUE(context.connected_clients.status(Clock::now()).empty());
}

TEST_F(SessionMetricsTest, counts_skipped_snapshots_of_unacknowledging_clients) {
    ClientSession session(context, peer(), Clock::now());
    hello(session);
    listen(session, 400ms, false);
    EXPECT_LE(snapshots, 5) << "the window";
    EXPECT_GT(metrics.snapshots_skipped[SkipReason::window].Value(), 5);
    // A transport that cannot write: frames come and go.
    const auto stuck_until = Clock::now() + 200ms;
    while (Clock::now() < stuck_until) {
        session.wait_for_write(Clock::now());
        std::this_thread::sleep_for(5ms);
    }
    listen(session, 50ms, false);
    EXPECT_GT(metrics.snapshots_skipped[SkipReason::pending].Value(), 3);
}

TEST_F(SessionMetricsTest, counts_refusals_by_reason) {
    ClientSession session(context, peer(), Clock::now());
    session.receive("garbage", Clock::now());
    EXPECT_TRUE(session.end());
    EXPECT_EQ(metrics.refusals[ErrorCode::invalid_argument].Value(), 1);
}

}  // namespace
}  // namespace jostle::server
