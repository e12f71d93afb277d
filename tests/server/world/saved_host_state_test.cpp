// SPDX-License-Identifier: MIT
#include "server/world/saved_host_state.h"

#include <gtest/gtest.h>

#include "jostle/physics/restore_point.h"
#include "jostle/physics/serialization.h"
#include "jostle/scenes/catalog.h"
#include "server/world/hosted_world.h"
#include "tests/support/error_of.h"
#include "tests/support/random.h"
#include "tests/support/step_time.h"

namespace jostle::server {
namespace {

using test::dt;
using test::error_of;

// Three clients who spawn, push, hold, drag, drive and delete what they may, and some of what they
// may not: the inputs of a tick follow from its number alone.
std::vector<Command> inputs_of(std::uint32_t tick, std::size_t entities) {
    test::Random random(tick);
    std::vector<Command> commands;
    for (ClientId client = 1; client <= 3; client++) {
        const auto any = static_cast<EntityId>(1 + random.below(entities + 3));
        SpawnCommand ball;
        ball.shape.geometry = physics::Sphere{0.3};
        ball.pose.position = random.vector(3) + physics::Vec3{0, 8, 0};
        const Action actions[] = {ball,
                                  ImpulseCommand{any, random.vector(20), {}},
                                  GrabCommand{any, random.vector(1)},
                                  DragCommand{random.vector(6)},
                                  ReleaseCommand{},
                                  DeleteCommand{any},
                                  PossessCommand{any},
                                  ControlCommand{{.axes = {1, 0.3F}}},
                                  ExplodeCommand{random.vector(4), 3, 2}};
        commands.push_back(
            {.client = client, .sequence = tick, .action = actions[random.below(9)], .reply = {}});
    }
    return commands;
}

struct Play {
    HostedWorld world;
    std::uint32_t tick = 0;
    std::string said;  // what became of the inputs

    void go_on(std::uint32_t ticks) {
        for (const std::uint32_t end = tick + ticks; tick < end;) {
            tick++;
            for (const Command& command : inputs_of(tick, world.host_state(tick).entities.size())) {
                const InputResult result = world.apply(command, tick);
                said += std::to_string(result.entity) +
                        (result.status.ok() ? "." : result.status.error().message);
            }
            ASSERT_TRUE(world.step(dt, tick).ok());
        }
    }
    Play copied() const {
        physics::RestorePoint point;
        point.capture(world.world());
        physics::World other = std::move(*physics::World::create({}));
        point.restore(other).expect();
        const SavedHostState host_state =
            *decode_host_state(encode_host_state(world.host_state(tick)));
        return {std::move(*HostedWorld::restore(std::move(other), host_state, limits(), 60, 0)),
                tick};
    }
    static HostLimits limits() { return {.scene = {.bodies_max = 400}, .bodies_owned_max = 12}; }
};

TEST(SavedHostState, restored_copy_evolves_identically) {
    for (const char* scene : {"stack", "race_track"}) {
        Play run{std::move(*HostedWorld::create(*scenes::find_scene(scene), Play::limits(), 1))};
        run.go_on(90);
        Play copy = run.copied();
        run.said.clear();
        run.go_on(120);
        copy.go_on(120);
        EXPECT_EQ(copy.said, run.said) << scene;
        EXPECT_EQ(physics::state_hash(copy.world.world()), physics::state_hash(run.world.world()))
            << scene;
        EXPECT_EQ(encode_host_state(copy.world.host_state(1)),
                  encode_host_state(run.world.host_state(1)));
        Frame frame, other;
        run.world.copy_into(frame);
        copy.world.copy_into(other);
        EXPECT_EQ(frame.entity_list->size(), other.entity_list->size());
        EXPECT_GT(run.world.host_state(1).owned.size(), 5u) << "the three did something";
    }
}

TEST(SavedHostState, does_not_reapply_processed_inputs) {
    Play run{std::move(*HostedWorld::create(*scenes::find_scene("stack"), Play::limits(), 1))};
    run.go_on(5);
    Play copy = run.copied();
    const InputResult again = copy.world.apply(inputs_of(5, 9).front(), 6);
    EXPECT_EQ(error_of(again.status).message,
              "input 5 is not greater than the client's last input 5");
}

TEST(SavedHostState, rejects_state_of_another_world) {
    Play run{std::move(*HostedWorld::create(*scenes::find_scene("stack"), Play::limits(), 1))};
    const Error error = error_of(HostedWorld::restore(
        std::move(*physics::World::create({})), run.world.host_state(0), Play::limits(), 60, 0));
    EXPECT_EQ(error.code, ErrorCode::corrupt_data);
    EXPECT_EQ(error.message, "corrupt host state: entity 1 has no body in the saved world");
}

TEST(SavedHostState, bytes_that_are_cut_or_changed_are_refused_or_read_within_bounds) {
    Play run{std::move(*HostedWorld::create(*scenes::find_scene("stack"), Play::limits(), 1))};
    run.go_on(60);
    const std::string whole = encode_host_state(run.world.host_state(60));
    for (std::size_t size = 0; size < whole.size(); size++)
        EXPECT_EQ(error_of(decode_host_state(whole.substr(0, size))).code, ErrorCode::corrupt_data);
    std::string later = whole;
    later[0] = 99;
    EXPECT_EQ(error_of(decode_host_state(later)).code, ErrorCode::failed_precondition);
    EXPECT_EQ(error_of(decode_host_state(whole + "x")).message,
              "corrupt host state: trailing bytes");
    test::Random random(4);
    for (int k = 0; k < 2000; k++) {
        std::string bytes = whole;
        for (int flips = 0; flips < 3; flips++)
            bytes[random.below(bytes.size())] = static_cast<char>(random.below(256));
        const Result<SavedHostState> host_state = decode_host_state(bytes);
        if (host_state.ok()) {
            EXPECT_LE(host_state->entities.size(), whole.size());
        }
    }
}

}  // namespace
}  // namespace jostle::server
