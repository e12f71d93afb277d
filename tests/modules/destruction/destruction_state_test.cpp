// SPDX-License-Identifier: MIT
//
// Bit-identical results for any number of threads and after saving, loading and restoring; scene
// settings.
#include <gtest/gtest.h>

#include "jostle/physics/restore_point.h"
#include "jostle/physics/serialization.h"
#include "tests/modules/destruction/walls.h"

namespace jostle::modules {
namespace {

using namespace physics;

// A ball breaks a wall; another wall stands next to it, and a block falls on the ground.
struct TestScene {
    Stage stage;

    explicit TestScene(int threads = 1, int chunks = 60) : stage({.threads = threads}) {
        stage.floor();
        stage.add(wall(chunks), standing());
        DestructibleDef second_wall = standing();
        second_wall.pose.position.x = 6;
        stage.add(wall(chunks), second_wall);
        const Vec3 half{0.5, 0.5, 0.5};
        stage.add(fracture_box(half, random_seeds(half, 30, 4)).value(),
                  {.pose = {.position = {-5, 3, 0}}, .bonds = {.tensile = 2e5, .shear = 4e5}});
        stage.ball({-2, 1.2, 0}, {20, 0, 0});
    }
};

TEST(DestructionState, result_is_bit_identical_for_any_thread_count) {
    std::uint64_t first = 0;
    for (const int threads : {1, 2, 4, 8}) {
        TestScene show(threads);
        show.stage.step(90);
        const std::uint64_t hash = state_hash(show.stage.world);
        if (threads == 1) first = hash;
        EXPECT_EQ(hash, first) << threads << " threads";
        EXPECT_GT(show.stage.world.bodies().size(), 8u);
    }
}

TEST(DestructionState, loaded_and_restored_worlds_continue_identically) {
    ASSERT_TRUE(registered);
    for (const int steps : {3, 6, 40}) {
        TestScene show;
        show.stage.step(steps);
        World& world = show.stage.world;
        const std::vector<std::byte> bytes = save(world);
        RestorePoint before;
        before.capture(world);
        show.stage.step(60);
        const std::uint64_t hash = state_hash(world);
        World loaded = std::move(*load(bytes));
        for (int k = 0; k < 60; k++) loaded.step(1.0 / 60).expect();
        EXPECT_EQ(state_hash(loaded), hash) << first_difference(world, loaded).value_or("");
        before.restore(world).expect();
        show.stage.step(60);
        EXPECT_EQ(state_hash(world), hash);
    }
}

// Any byte of the module's state may have any value: the load fails, or the world can be stepped.
TEST(DestructionState, corrupted_bytes_are_rejected_or_harmless) {
    TestScene show(1, 8);
    show.stage.step(10);
    const std::vector<std::byte> saved = save_module(*show.stage.destruction);
    int refused = 0, stepped = 0;
    for (std::size_t at = 0; at < saved.size(); at += 5) {
        std::vector<std::byte> bytes = saved;
        bytes[at] = ~bytes[at];
        auto corrupted = std::make_unique<Destruction>();
        if (!load_module(*corrupted, bytes).ok()) {
            refused++;
            continue;
        }
        if (at % 37 != 0) continue;  // worlds are slow
        TestScene other(1, 8);
        other.stage.step(2);
        other.stage.world.remove_module("destruction").expect();
        other.stage.world.add_module(std::move(corrupted)).expect();
        for (int k = 0; k < 12; k++) static_cast<void>(other.stage.world.step(1.0 / 60).ok());
        stepped++;
    }
    RecordProperty("refused", refused);
    RecordProperty("stepped", stepped);
    EXPECT_GT(refused, 100);
    EXPECT_GT(stepped, 10);
}

TEST(DestructionState, scene_settings_place_walls) {
    Stage stage;
    stage.destruction
        ->configure(stage.world,
                    {.numbers = {{"count", 3}, {"spacing", 9}, {"chunks", 40}, {"x", 5}}})
        .expect();
    EXPECT_EQ(stage.destruction->size(), 3u);
    stage.step(5);
    const auto third = stage.destruction->bodies({2, 1}).value();
    ASSERT_EQ(third.size(), 1u);
    EXPECT_NEAR(stage.world.body(third[0])->pose.position.x, 23, 1e-12);
    EXPECT_EQ(stage.world.body(third[0])->type, BodyType::static_body);
    ChannelWriter writer([](BodyId) { return 0u; });
    stage.destruction->publish(stage.world, writer);
    ASSERT_EQ(writer.channels().size(), 1u);
    EXPECT_EQ(writer.channels()[0].values.size(), 9u) << "three numbers per wall";
    EXPECT_FALSE(stage.destruction->configure(stage.world, {.numbers = {{"chunks", 0}}}).ok());
}

}  // namespace
}  // namespace jostle::modules
