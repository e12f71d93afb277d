// SPDX-License-Identifier: MIT
//
// Bit-identical results for any number of threads and after saving, loading and restoring;
// corrupted bytes.
#include <vector>

#include "jostle/physics/restore_point.h"
#include "jostle/physics/serialization.h"
#include "tests/modules/character/rough_ground.h"
#include "tests/modules/character/stage.h"

namespace jostle::modules {
namespace {

using namespace physics;

const bool registered =
    register_module("character", [] { return std::make_unique<Characters>(); }).ok();

// A crowd of both kinds of characters among crates on rough ground, with a lift.
World crowd(int threads) {
    Stage stage({.threads = threads});
    test::add_static(stage.world, {.geometry = rough_mesh(5)});
    for (int k = 0; k < 60; k++)
        test::add(stage.world, {.geometry = Box{{0.3, 0.3, 0.3}},
                                .position = {-6.0 + k % 8 * 1.6, 4, -6.0 + k / 8 * 1.6},
                                .density = 100});
    test::add(stage.world, {.geometry = Box{{3, 0.2, 3}},
                            .position = {0, 4, 0},
                            .velocity = {0, 0.2, 0},
                            .spin = {0, 0.7, 0},
                            .type = BodyType::kinematic});
    for (int k = 0; k < 24; k++)
        stage.add({.kind = k % 3 == 0 ? CharacterKind::rigid : CharacterKind::sweeping,
                   .feet = {-5.3 + k % 6 * 2.1, 5.5, -5.3 + k / 6 * 2.1}});
    return std::move(stage.world);
}

// Controls change regularly; they depend only on the step.
void play(World& world, int steps) {
    auto& characters = dynamic_cast<Characters&>(*world.module("character"));
    for (int k = 0; k < steps; k++) {
        test::Random random(world.step_count() / 20);
        for (const CharacterId id : characters.ids()) {
            const SinCos direction = sin_cos(random.in(-pi, pi));
            test::must(
                characters.set_controls(id, {.walk = Vec3{direction.cos, 0, direction.sin} * 4,
                                             .jump = random.below(3) == 0,
                                             .crouch = random.below(3) == 0}));
        }
        test::must(world.step(1 / hz));
    }
}

TEST(Identity, result_is_bit_identical_for_any_thread_count) {
    std::uint64_t first = 0;
    for (const int threads : {1, 2, 3, 4, 8}) {
        World world = crowd(threads);
        play(world, 240);
        if (threads == 1) first = state_hash(world);
        EXPECT_EQ(state_hash(world), first) << threads << " threads";
    }
}

TEST(Identity, loaded_and_restored_worlds_continue_bit_identically) {
    ASSERT_TRUE(registered);
    World world = crowd(1);
    play(world, 100);
    const std::vector<std::byte> bytes = save(world);
    RestorePoint before;
    before.capture(world);
    play(world, 140);
    const std::uint64_t hash = state_hash(world);
    World loaded = test::must(load(bytes));
    play(loaded, 140);
    EXPECT_EQ(state_hash(loaded), hash);
    test::must(before.restore(world));
    play(world, 140);
    EXPECT_EQ(state_hash(world), hash);
}

// Inverts each byte of the state and clears some: the load must fail or be harmless.
TEST(Identity, corrupted_bytes_are_rejected_or_harmless) {
    World world = crowd(1);
    play(world, 30);
    const std::vector<std::byte> saved = save_module(*world.module("character"));
    RestorePoint start;
    start.capture(world);
    int refused = 0, taken = 0;
    test::Random random(9);
    for (std::size_t at = 0; at < saved.size(); at++) {
        std::vector<std::byte> bytes = saved;
        bytes[at] ^= static_cast<std::byte>(1 + random.below(255));
        auto corrupted = std::make_unique<Characters>();
        if (!load_module(*corrupted, bytes).ok()) {
            refused++;
            continue;
        }
        if (++taken % 40 != 0) continue;
        test::must(start.restore(world));
        test::must(world.remove_module("character"));
        test::must(world.add_module(std::move(corrupted)));
        for (int k = 0; k < 3; k++) test::must(world.step(1 / hz));
        EXPECT_TRUE(is_finite(world.summary().linear_momentum));
        EXPECT_TRUE(load(save(world)).ok()) << "byte " << at;
    }
    for (std::size_t size = 0; size < saved.size(); size += 7)
        EXPECT_FALSE(
            load_module(*std::make_unique<Characters>(), std::span(saved).first(size)).ok());
    record("forgeries_refused", refused);
    record("forgeries_taken", taken);
    EXPECT_GT(refused, 500);
}

TEST(Identity, errors_name_fields_out_of_range) {
    Stage stage;
    stage.add({.feet = {1, 0, 2}});
    std::vector<std::byte> bytes = save_module(*stage.crowd);
    // The number of characters is the first value.
    bytes[0] = std::byte{2};
    Characters other;
    const Status status = load_module(other, bytes);
    ASSERT_FALSE(status.ok());
    EXPECT_FALSE(status.error().message.empty());
}

}  // namespace
}  // namespace jostle::modules
