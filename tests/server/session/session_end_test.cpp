// SPDX-License-Identifier: MIT
#include "server/session/session_end.h"

#include <gtest/gtest.h>

#include "jostle/scenes/catalog.h"
#include "tests/server/session/session_harness.h"

namespace jostle::server {
namespace {

TEST(SessionEnd, replaced_world_is_resumable_and_closed_world_is_not) {
    test::TestServer server;
    const auto replaced = server.host(*scenes::find_scene("stack"));
    EXPECT_FALSE(end_of_world(*replaced));
    ASSERT_TRUE(replaced->stop_for_replacement());
    std::optional<SessionEnd> end = end_of_world(*replaced);
    ASSERT_TRUE(end);
    EXPECT_TRUE(end->resumable);
    EXPECT_EQ(end->error.code, ErrorCode::unavailable);
    EXPECT_EQ(end->notice, NoticeKind::world_restarted);

    const auto closed = *server.worlds.create("closed", *scenes::find_scene("stack"));
    closed->stop();
    end = end_of_world(*closed);
    ASSERT_TRUE(end);
    EXPECT_FALSE(end->resumable);
    EXPECT_EQ(end->error.code, ErrorCode::aborted);
    EXPECT_EQ(end->notice, NoticeKind::world_closed);
}

TEST(SessionEnd, only_timeouts_end_a_session_before_its_hello) {
    test::TestServer server;
    const Peer peer;
    const SessionTimeouts timeouts(server.config.stream, server.now);
    const SessionMetrics metrics(server.context);
    SessionResume resume(server.context, peer);
    Outbox outbox;
    for (int i = 0; i < 300; i++) outbox.push_reply("pong");
    const auto after = [&](std::chrono::milliseconds time) {
        return end_of_session(timeouts, metrics, resume, outbox, nullptr, server.now + time);
    };
    EXPECT_FALSE(after(std::chrono::milliseconds(5000)));
    const std::optional<SessionEnd> end = after(std::chrono::milliseconds(5001));
    ASSERT_TRUE(end);
    EXPECT_EQ(end->notice, NoticeKind::refused);
    EXPECT_FALSE(end->resumable);
}

}  // namespace
}  // namespace jostle::server
