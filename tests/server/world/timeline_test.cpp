// SPDX-License-Identifier: MIT
//
// The time of a room: steps, speed and rewinds.
#include "server/world/timeline.h"

#include <gtest/gtest.h>

#include <map>
#include <thread>

#include "jostle/physics/serialization.h"
#include "jostle/scenes/catalog.h"
#include "server/world/world_directory.h"
#include "tests/support/error_of.h"
#include "tests/support/step_time.h"
#include "tests/support/wait_until.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using test::dt;
using test::error_of;
using test::wait_until;

using Ticks = std::vector<std::uint32_t>;

TEST(Timeline, stores_one_state_per_second_and_restores_it) {
    HostedWorld world = std::move(*HostedWorld::create(*scenes::find_scene("stack"), {}, 1));
    Timeline timeline(60, true);
    std::map<std::uint32_t, std::uint64_t> hashes;
    for (std::uint32_t tick = 1; tick <= 550; tick++) {
        ASSERT_TRUE(world.step(dt, tick).ok());
        timeline.on_tick(tick, true, world, 5, 0);
        hashes[tick] = physics::state_hash(world.world());
    }
    EXPECT_EQ(*timeline.ticks(), (Ticks{241, 301, 361, 421, 481, 541}));
    for (const std::uint32_t tick : *timeline.ticks()) {
        const HostedWorld past = *timeline.world_at(tick, {}, 1, 0);
        EXPECT_EQ(physics::state_hash(past.world()), hashes[tick]);
    }
    EXPECT_EQ(error_of(timeline.world_at(240, {}, 1, 0)).code, ErrorCode::not_found);
    // A paused world adds no states, and new settings drop those that they do not allow.
    timeline.on_tick(551, false, world, 5, 0);
    EXPECT_EQ(timeline.ticks()->size(), 6u);
    timeline.on_tick(552, true, world, 2, 0);
    EXPECT_EQ(*timeline.ticks(), (Ticks{421, 481, 541}));
    timeline.on_tick(553, true, world, 0, 0);
    EXPECT_TRUE(timeline.ticks()->empty());
    EXPECT_EQ(timeline.bytes(), 0u);
}

TEST(Timeline, of_a_persisted_world_has_only_ticks_of_its_history) {
    HostedWorld world = std::move(*HostedWorld::create(*scenes::find_scene("stack"), {}, 1));
    Timeline timeline(60, false);
    for (std::uint32_t tick = 1; tick <= 200; tick++) timeline.on_tick(tick, true, world, 60, 0);
    EXPECT_EQ(*timeline.ticks(), (Ticks{1, 61, 121, 181}));
    timeline.on_tick(201, true, world, 60, 100);
    EXPECT_EQ(*timeline.ticks(), (Ticks{121, 181}));
    EXPECT_EQ(error_of(timeline.world_at(121, {}, 1, 0)).code, ErrorCode::not_found);
    EXPECT_EQ(timeline.bytes(), 0u);
}

// A room whose ticks run when the test calls them.
class RoomTimeTest : public testing::Test {
protected:
    explicit RoomTimeTest(bool own_ticks = false) : worlds({.own_ticks = own_ticks}, 4) {
        host = *worlds.create("room", *scenes::find_scene("stack"), {},
                              RoomProperties{.timeline_seconds = 60});
        send(EnterRoom{.member = "subject/ada"}, 0);
    }
    ~RoomTimeTest() override { worlds.stop_all(); }
    template <class Kind>
    void send(Kind kind, std::uint32_t number) {
        ASSERT_TRUE(host->mailbox().push({.client = 1,
                                          .sequence = number,
                                          .action = RoomCommand{std::move(kind)},
                                          .reply = number == 0 ? nullptr : queue}));
    }
    template <class Kind>
    InputResult act(Kind kind) {
        send(std::move(kind), ++sequence);
        tick();
        const std::vector<InputResult> results = queue->take();
        EXPECT_EQ(results.size(), 1u);
        return results.empty() ? InputResult{} : results.back();
    }
    void tick(int times = 1) {
        for (int k = 0; k < times; k++) host->tick(due += 16666us);
    }
    std::uint64_t steps() const { return host->stopped_world().world().step_count(); }

    WorldDirectory worlds;
    std::shared_ptr<WorldHost> host;
    std::shared_ptr<ResultQueue> queue = std::make_shared<ResultQueue>();
    Clock::time_point due = Clock::time_point() + 5s;
    std::uint32_t sequence = 0;
};

TEST_F(RoomTimeTest, member_steps_a_paused_room_and_builds_in_it) {
    tick();
    const Error refused = error_of(act(StepRoom{2}).status);
    EXPECT_EQ(refused.message, "no member of the room paused the world; pause it before a step");
    EXPECT_TRUE(act(PauseRoom{true}).status.ok());
    tick();
    const std::uint64_t before = steps();
    tick(5);
    EXPECT_EQ(steps(), before);
    EXPECT_TRUE(act(StepRoom{2}).status.ok());
    tick(10);
    EXPECT_EQ(steps(), before + 2);
    SpawnCommand ball;
    ball.shape.geometry = physics::Sphere{0.3};
    ball.pose.position = {5, 9, 0};
    ASSERT_TRUE(host->mailbox().push(
        {.client = 1, .sequence = ++sequence, .action = ball, .reply = queue}));
    tick();
    EXPECT_TRUE(queue->take().at(0).status.ok()) << "a paused room can be built in";
    ASSERT_TRUE(host->mailbox().push(
        {.client = 1, .sequence = ++sequence, .action = ReleaseCommand{}, .reply = queue}));
    tick();
    EXPECT_EQ(error_of(queue->take().at(0).status).code, ErrorCode::resource_exhausted);
    EXPECT_TRUE(act(PauseRoom{false}).status.ok());
    tick(3);
    EXPECT_GT(steps(), before + 2);
}

TEST_F(RoomTimeTest, owner_rewinds_to_a_state_of_the_timeline) {
    tick(200);
    const Ticks ticks = *host->frame()->restorable_ticks;
    EXPECT_EQ(ticks.size(), 4u);
    const Error missing = error_of(act(RewindRoom{ticks[1] + 1}).status);
    EXPECT_EQ(missing.code, ErrorCode::not_found);
    EXPECT_TRUE(missing.message.ends_with("one per second")) << missing.message;
    EXPECT_TRUE(act(RewindRoom{ticks[1]}).status.ok());
    const std::uint32_t last = host->frame()->tick;
    worlds.reset_requested();
    const auto rewound = worlds.find("room");
    ASSERT_NE(rewound, host);
    EXPECT_GT(rewound->frame()->tick, last) << "ticks are never reused";
    EXPECT_EQ(rewound->stopped_world().world().step_count() + last - ticks[1], steps());
    rewound->tick(due += 16666us);
    EXPECT_EQ(rewound->frame()->restorable_ticks->front(), ticks[0])
        << "the timeline survives the rewind";
    EXPECT_TRUE(rewound->stopped_world().room()->state().find(1));
}

class RunningRoomTest : public RoomTimeTest {
protected:
    RunningRoomTest() : RoomTimeTest(true) {}
};

TEST_F(RunningRoomTest, slow_motion_changes_the_pace_only) {
    send(SetRoomSpeed{25}, 1);
    ASSERT_TRUE(wait_until([&] { return host->frame()->speed_percent == 25; }));
    const FramePtr first = host->frame();
    const auto begin = Clock::now();
    std::this_thread::sleep_for(1200ms);
    const FramePtr last = host->frame();
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    EXPECT_NEAR(last->tick - first->tick + last->late_ticks - first->late_ticks, 15 * seconds, 3);
    EXPECT_NEAR(last->time_scale, 0.25, 0.08);
    const double late = static_cast<double>(last->late_us - first->late_us) / 1e6;
    const double simulated = (last->tick - first->tick) / 60.0;
    EXPECT_NEAR(late, 3 * simulated, 0.05) << "clients pace ticks by their due times";
    EXPECT_EQ(host->speed_percent(), 25u);
}

}  // namespace
}  // namespace jostle::server
