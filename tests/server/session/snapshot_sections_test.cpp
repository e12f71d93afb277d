// SPDX-License-Identifier: MIT
//
// Each section alone, with frames of the test's own.
#include "server/session/snapshot_sections.h"

#include <gtest/gtest.h>

#include "jostle/scenes/catalog.h"
#include "jostle/v1/play.pb.h"
#include "server/session/optional_sections.h"
#include "tests/server/session/session_harness.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;

class SnapshotSectionsTest : public testing::Test {
protected:
    // A frame of tick `tick` after `events` ticks with events, of which the newest `retained`
    // remain.
    static std::shared_ptr<Frame> frame(std::uint32_t tick, std::uint32_t events = 0,
                                        std::uint32_t retained = 0) {
        auto recent = std::make_shared<RecentEvents>();
        recent->count = events;
        for (std::uint32_t k = events - retained; k < events; k++) {
            auto one = std::make_shared<TickEvents>();
            one->tick = k + 1;
            one->woke = {1};
            recent->ticks.push_back(std::move(one));
        }
        auto made = std::make_shared<Frame>();
        made->tick = tick;
        made->events = std::move(recent);
        return made;
    }
    v1::Snapshot appended(SnapshotSection& section, const FramePtr& frame,
                          Clock::time_point now = Clock::time_point() + 1000s) {
        SnapshotParts parts;
        section.append(frame, now, parts);
        v1::Snapshot snapshot;
        EXPECT_TRUE(snapshot.ParseFromString(parts.fields));
        return snapshot;
    }

    test::TestServer server;
    const std::shared_ptr<WorldHost> host = server.host(*scenes::find_scene("stack"));
    BroadcastCache broadcast{host, 32};
};

TEST_F(SnapshotSectionsTest, events_are_sent_once_and_report_missed_ticks) {
    EventsSection events(broadcast);
    events.set_cursor(2);
    EXPECT_FALSE(events.has_changes(*frame(10, 2, 2)));
    const auto newer = frame(11, 5, 5);
    EXPECT_TRUE(events.has_changes(*newer));
    const v1::Snapshot first = appended(events, newer);
    ASSERT_EQ(first.events_size(), 3);
    EXPECT_EQ(first.events(0).tick(), 3u);
    EXPECT_EQ(first.events(0).missed(), 0u);
    EXPECT_EQ(appended(events, newer).events_size(), 0);
    const v1::Snapshot late = appended(events, frame(90, 80, 64));
    ASSERT_EQ(late.events_size(), 64);
    EXPECT_EQ(late.events(0).missed(), 11u) << "ticks 6 to 16";
    EXPECT_EQ(late.events(1).missed(), 0u);
    EXPECT_EQ(events.cursor(), 80u);
}

TEST_F(SnapshotSectionsTest, statistics_are_sent_twice_per_second) {
    StatsSection stats({.stats_per_second = 2}, server.sessions, broadcast);
    const Clock::time_point start = Clock::time_point() + 1000s;
    EXPECT_TRUE(appended(stats, frame(1), start).has_stats());
    EXPECT_FALSE(appended(stats, frame(2), start + 499ms).has_stats());
    EXPECT_TRUE(appended(stats, frame(3), start + 500ms).has_stats());
}

TEST_F(SnapshotSectionsTest, controlled_entity_is_sent_every_fourth_tick_at_60_hz) {
    ControlledEntitySection section(7, 60);
    const auto driving = [](std::uint32_t tick, ClientId client, EntityId entity) {
        auto made = frame(tick);
        made->controlled_entities = std::make_shared<std::vector<ControlledEntityState>>(
            1, ControlledEntityState{client, entity, "car", {1, 2, tick}});
        return made;
    };
    EXPECT_FALSE(appended(section, driving(1, 8, 3)).has_controlled_entity()) << "of client 8";
    EXPECT_TRUE(appended(section, driving(2, 7, 3)).has_controlled_entity());
    EXPECT_FALSE(appended(section, driving(5, 7, 3)).has_controlled_entity());
    EXPECT_TRUE(appended(section, driving(6, 7, 3)).has_controlled_entity());
    EXPECT_TRUE(appended(section, driving(7, 7, 4)).has_controlled_entity()) << "another entity";
    EXPECT_FALSE(appended(section, frame(20)).has_controlled_entity());
}

TEST_F(SnapshotSectionsTest, channels_select_kinds_by_name) {
    const std::vector<physics::ChannelKind> kinds{
        {.name = "wheels"},
        {.name = motion_kind},
        {.name = "heat"},
        {.name = "ropes", .form = physics::ChannelForm::points}};
    EXPECT_EQ(requested_channels(kinds, {"heat", "unknown"}), 0b100u);
    EXPECT_EQ(requested_channels(kinds, {"*"}), 0b1101u);
    EXPECT_EQ(requested_channels(kinds, {"*", motion_kind}), 0b1111u);
    EXPECT_EQ(requested_channels(kinds, {"points:*"}), 0b1000u);
    EXPECT_EQ(point_channels(kinds), 0b1000u);
    EXPECT_EQ(motion_channel(kinds), 0b010u);
    EXPECT_EQ(motion_channel({}), 0u);
}

TEST_F(SnapshotSectionsTest, listener_counts_rise_and_fall_with_the_sections) {
    FrameListeners listeners;
    EventsSection events(broadcast);
    ChannelsSection motion(0b10, 0b10), other(0b01, 0b10);
    ControlledEntitySection controlled(7, 60);
    const std::vector<SnapshotSection*> sections{&events, &motion, &other, &controlled};
    for (SnapshotSection* section : sections) section->on_enter(listeners);
    EXPECT_EQ(listeners.events, 1);
    EXPECT_EQ(listeners.motion, 1);
    EXPECT_EQ(listeners.controlled_entities, 1);
    for (SnapshotSection* section : sections) section->on_leave(listeners);
    EXPECT_EQ(listeners.events + listeners.motion + listeners.controlled_entities, 0);
}

TEST_F(SnapshotSectionsTest, client_update_repeats_no_counter) {
    CommandMailbox mailbox(4);
    InputIntake inputs(mailbox, {.client = 7}, {}, std::make_shared<ResultQueue>(), server.now);
    const SnapshotSchedule schedule({}, 60, 1);
    ClientUpdateSection section(inputs, schedule);
    inputs.resume(5, 4, {{.sequence = 4, .status = {}, .tick = 9, .margin_us = -3}});
    EXPECT_TRUE(section.has_changes(*frame(10)));
    SnapshotParts first, second;
    section.append(frame(10), server.now, first);
    EXPECT_EQ(first.update.results.size(), 1u);
    EXPECT_EQ(first.update.input_sequence, 4u);
    EXPECT_EQ(first.update.input_margin_us, -3);
    EXPECT_EQ(first.update.input_received, 0u) << "inputs arrive on the stream";
    inputs.on_results_sent();
    EXPECT_FALSE(section.has_changes(*frame(11)));
    section.report_received_inputs();
    section.append(frame(11), server.now, second);
    EXPECT_EQ(second.update.input_sequence, 0u);
    EXPECT_EQ(second.update.input_received, 5u);
}

TEST_F(SnapshotSectionsTest, sections_exist_only_if_requested) {
    Outbox outbox;
    BaselineTracker baselines;
    EntityStream entities(broadcast, baselines, outbox);
    InputIntake inputs(host->mailbox(), {.client = 7}, {}, std::make_shared<ResultQueue>(),
                       server.now);
    const SnapshotSchedule schedule({}, 60, 1);
    const auto poses = broadcast.poses({});
    const SnapshotSections::Sources sources{.context = server.context,
                                            .broadcast = broadcast,
                                            .poses = *poses,
                                            .entities = entities,
                                            .inputs = inputs,
                                            .schedule = schedule,
                                            .client = 7};
    Hello hello;
    SnapshotSections none(sources, hello);
    EXPECT_EQ(none.events(), nullptr);
    EXPECT_EQ(none.cells(), nullptr);
    EXPECT_EQ(none.channel_kinds(), 0u);
    hello.events = true;
    hello.max_kbps = 64;
    SnapshotSections some(sources, hello);
    EXPECT_NE(some.events(), nullptr);
    EXPECT_NE(some.cells(), nullptr);
}

}  // namespace
}  // namespace jostle::server
