// SPDX-License-Identifier: MIT
//
// Bit-identical results for any number of threads and after saving, loading and restoring; scene
// settings.
#include <gtest/gtest.h>

#include <cmath>

#include "jostle/physics/restore_point.h"
#include "jostle/physics/serialization.h"
#include "tests/modules/ragdoll/figures.h"

namespace jostle::modules {
namespace {

using namespace physics;

const bool registered =
    register_module("ragdoll", [] { return std::make_unique<Ragdolls>(); }).ok();

// One limp figure, one that waves with its muscles, and one that leaves kinematic mode.
struct TestScene {
    Stage stage;
    RagdollId limp, powered, kinematic;

    explicit TestScene(int threads = 1) : stage({.threads = threads}) {
        stage.floor();
        limp = stage.add(human_figure());
        powered = stage.add(human_figure(), {{0, 0, 1.5}, {}});
        kinematic = stage.add(human_figure(1.5), {{0.3, 0, 3}, {}});
        stage.ragdolls->set_mode(stage.world, powered, RagdollMode::powered, 0.5).expect();
        stage.ragdolls->set_mode(stage.world, kinematic, RagdollMode::kinematic).expect();
    }
};
void play(World& world, const TestScene& show, int from, int to) {
    auto& ragdolls = dynamic_cast<Ragdolls&>(*world.module("ragdoll"));
    for (int k = from; k < to; k++) {
        RagdollPose pose{.root = {{0, 0, 1.5}, {}}, .rotations = std::vector<Quat>(11)};
        pose.rotations[3] = from_axis_angle({0, 0, 1}, 0.5 * sin_cos(0.1 * k).sin);
        ragdolls.set_pose(show.powered, pose).expect();
        if (k == 60) ragdolls.set_mode(world, show.kinematic, RagdollMode::limp, 0).expect();
        world.step(1.0 / 60).expect();
    }
}

TEST(RagdollState, result_is_bit_identical_for_any_thread_count) {
    std::uint64_t first = 0;
    for (const int threads : {1, 2, 4, 8}) {
        TestScene show(threads);
        play(show.stage.world, show, 0, 120);
        const std::uint64_t hash = state_hash(show.stage.world);
        if (threads == 1) first = hash;
        EXPECT_EQ(hash, first) << threads << " threads";
    }
}

TEST(RagdollState, loaded_and_restored_worlds_continue_identically) {
    ASSERT_TRUE(registered);
    TestScene show;
    World& world = show.stage.world;
    play(world, show, 0, 40);
    const std::vector<std::byte> bytes = save(world);
    RestorePoint before;
    before.capture(world);
    play(world, show, 40, 120);
    const std::uint64_t hash = state_hash(world);
    World loaded = std::move(*load(bytes));
    play(loaded, show, 40, 120);
    EXPECT_EQ(state_hash(loaded), hash);
    before.restore(world).expect();
    play(world, show, 40, 120);
    EXPECT_EQ(state_hash(world), hash);
}

// Any byte of the module's state may have any value: the load fails, or the world can be stepped.
TEST(RagdollState, corrupted_bytes_are_rejected_or_harmless) {
    TestScene show;
    play(show.stage.world, show, 0, 10);
    const std::vector<std::byte> saved = save_module(*show.stage.ragdolls);
    int refused = 0;
    for (std::size_t at = 0; at < saved.size(); at += 3) {
        std::vector<std::byte> bytes = saved;
        bytes[at] = ~bytes[at];
        TestScene other;
        auto corrupted = std::make_unique<Ragdolls>();
        if (!load_module(*corrupted, bytes).ok()) {
            refused++;
            continue;
        }
        if (at % 31 != 0) continue;  // worlds are slow
        other.stage.world.remove_module("ragdoll").expect();
        other.stage.world.add_module(std::move(corrupted)).expect();
        for (int k = 0; k < 3; k++) static_cast<void>(other.stage.world.step(1.0 / 60).ok());
    }
    RecordProperty("refused", refused);
    EXPECT_GT(refused, 100);
}

TEST(RagdollState, scene_settings_place_figures) {
    Stage stage;
    stage.floor();
    stage.ragdolls
        ->configure(stage.world,
                    {.numbers = {{"count", 5}, {"spacing", 3}, {"x", 10}, {"powered", 1}}})
        .expect();
    EXPECT_EQ(stage.ragdolls->size(), 5u);
    const Vec3 last = stage.world.body(stage.ragdolls->bodies({4, 1})->front())->pose.position;
    EXPECT_NEAR(last.x, 13, 1e-9);
    EXPECT_NEAR(last.z, 3, 1e-9);
    EXPECT_EQ(*stage.ragdolls->mode({4, 1}), RagdollMode::powered);
    const Status both =
        stage.ragdolls->configure(stage.world, {.numbers = {{"powered", 1}, {"kinematic", 1}}});
    EXPECT_EQ(both.error().message, "powered and kinematic are both 1; at most one must be 1");
}

}  // namespace
}  // namespace jostle::modules
