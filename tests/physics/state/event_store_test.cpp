// SPDX-License-Identifier: MIT
//
// What happens between steps is published with the next one, and no longer.
#include "physics/src/state/event_store.h"

#include <gtest/gtest.h>

namespace jostle::test {
namespace {
using namespace physics;

TEST(EventStore, step_starts_with_pending_events) {
    EventStore events;
    events.woke.push_back({1, 1});
    events.hits.emplace_back();
    events.pending.woke.push_back({7, 2});
    events.pending.ended.resize(2);
    events.pending.left.resize(3);
    events.begin_step();
    ASSERT_EQ(events.woke.size(), 1u);
    EXPECT_EQ(events.woke[0], (BodyId{7, 2}));
    EXPECT_EQ(events.contacts_ended.size(), 2u);
    EXPECT_EQ(events.triggers_left.size(), 3u);
    EXPECT_TRUE(events.hits.empty()) << "of the last step";
    EXPECT_FALSE(events.empty());
    events.begin_step();
    EXPECT_TRUE(events.empty());
}

TEST(EventStore, clearing_published_events_keeps_pending_events) {
    EventStore events;
    events.quarantined.push_back({1, 1});
    events.pending.woke.push_back({2, 1});
    events.clear_published();
    EXPECT_TRUE(events.empty());
    EXPECT_EQ(events.pending.woke.size(), 1u);
}

}  // namespace
}  // namespace jostle::test
