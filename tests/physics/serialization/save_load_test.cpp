// SPDX-License-Identifier: MIT
//
// A loaded world goes on as if nothing had happened: mid-flight, mid-impact, asleep, carried.
#include <gtest/gtest.h>

#include <optional>

#include "tests/support/test_scenes.h"

namespace jostle::test {
namespace {
using namespace physics;

World again(const World& world) {
    return must(load(save(world)));
}

class SaveLoad : public testing::TestWithParam<TestScene> {};

// The first copy runs to the end beside the original. Later ones, saved before and after each
// disturbance, run for 90 steps.
TEST_P(SaveLoad, continues_bit_identically) {
    World original = GetParam().make(1), first = again(original);
    std::optional<World> copy;
    const auto play = [](World& world, int step) {
        disturb(world, step);
        must(world.step(1.0 / 60));
    };
    for (int step = 0; step < 420; step++) {
        if (step % 100 == 37) copy = again(original);
        for (World* world : {&original, &first}) play(*world, step);
        if (copy) play(*copy, step);
        if (step % 100 == 99) {
            ASSERT_EQ(state_hash(original), state_hash(first))
                << "step " << step << ": " << first_difference(original, first).value_or("");
        }
        if (step % 100 == 26 && copy) {
            ASSERT_EQ(state_hash(original), state_hash(*copy))
                << "step " << step << ": " << first_difference(original, *copy).value_or("");
            copy.reset();
        }
    }
}

TEST_P(SaveLoad, saving_is_const_and_repeatable) {
    World world = GetParam().make(1);
    run(world, 1.3);
    const std::uint64_t before = state_hash(world);
    const auto bytes = save(world);
    EXPECT_EQ(state_hash(world), before);
    EXPECT_EQ(save(again(world)), bytes);
    EXPECT_EQ(state_hash(again(world)), before);
}

TEST_P(SaveLoad, copy_loaded_every_step_stays_identical) {
    World original = GetParam().make(1), copy = GetParam().make(1);
    for (int step = 0; step < 150; step++) {
        copy = again(copy);
        must(original.step(1.0 / 60));
        must(copy.step(1.0 / 60));
        ASSERT_EQ(state_hash(original), state_hash(copy))
            << "step " << step << ": " << first_difference(original, copy).value_or("");
    }
}

INSTANTIATE_TEST_SUITE_P(scenes, SaveLoad, testing::ValuesIn(test_scenes()),
                         [](const auto& scene) { return scene.param.name; });

TEST(SaveLoadStates, round_trips_during_an_impact) {
    World world = make_world();
    add_floor(world, 0.5, 0.6);
    add(world, {.position = {0, 2, 0}, .rotation = Random(1).rotation(), .restitution = 0.6});
    while (world.events().contacts_began.empty()) must(world.step(1.0 / 60));
    World copy = again(world);
    run(world, 2);
    run(copy, 2);
    EXPECT_EQ(state_hash(world), state_hash(copy)) << first_difference(world, copy).value_or("");
}

TEST(SaveLoadStates, round_trips_while_bodies_wake) {
    World original = guarded_scene(), copy = guarded_scene();
    int thawed = 0;
    for (int step = 0; step < 330; step++) {
        if (step > 100) copy = again(copy);
        disturb(original, step);
        disturb(copy, step);
        must(original.step(1.0 / 60));
        must(copy.step(1.0 / 60));
        thawed += static_cast<int>(original.events().woke.size());
        ASSERT_EQ(state_hash(original), state_hash(copy))
            << "step " << step << ": " << first_difference(original, copy).value_or("");
    }
    EXPECT_GT(thawed, 200);
}

TEST(SaveLoadStates, round_trips_asleep_and_wakes_identically) {
    World world = make_world();
    add_floor(world);
    for (int i = 0; i < 4; i++) add(world, {.position = {0, 0.5 + i, 0}});
    run(world, 4);
    ASSERT_EQ(world.summary().awake_bodies, 0);
    World copy = again(world);
    EXPECT_EQ(copy.summary().awake_bodies, 0);
    for (World* w : {&world, &copy}) {
        add(*w, {.geometry = Sphere{0.4}, .position = {-3, 2.5, 0}, .velocity = {15, 0, 0}});
        run(*w, 3);
    }
    EXPECT_EQ(state_hash(world), state_hash(copy)) << first_difference(world, copy).value_or("");
}

TEST(SaveLoadStates, pending_forces_are_saved) {
    World world = make_world({.gravity = {}});
    const BodyId box = add(world, {});
    must(world.apply_force(box, {6000, 0, 0}, {0, 0.1, 0}));
    World copy = again(world);
    must(world.step(1.0 / 60));
    must(copy.step(1.0 / 60));
    EXPECT_GT(velocity_of(copy, box).x, 0.09);
    EXPECT_EQ(state_hash(world), state_hash(copy));
}

TEST(SaveLoadStates, ids_and_user_data_are_saved) {
    World world = make_world();
    const BodyId gone = add(world, {});
    const BodyId kept = must(world.create_body({.user_data = 0xfeedfacecafef00dull}, ShapeDef{}));
    must(world.destroy_body(gone));
    World copy = again(world);
    EXPECT_EQ(state_of(copy, kept).user_data, 0xfeedfacecafef00dull);
    EXPECT_FALSE(copy.contains(gone));
    EXPECT_EQ(add(copy, {}), add(world, {}));  // the next id is the same, too
}

TEST(SaveLoadStates, queries_return_the_same_results) {
    World world = pile_scene();
    run(world, 3);
    const World copy = again(world);
    Random random(4);
    for (int i = 0; i < 200; i++) {
        const Ray ray{random.vector(5) + Vec3{0, 5, 0}, random.vector(10)};
        const auto a = must(world.queries().cast_ray(ray)), b = must(copy.queries().cast_ray(ray));
        ASSERT_EQ(a.has_value(), b.has_value());
        if (!a) continue;
        EXPECT_EQ(a->shape, b->shape);
        EXPECT_EQ(a->fraction, b->fraction);
    }
}

TEST(SaveLoadStates, round_trips_an_empty_world) {
    World world = make_world({.gravity = {1, 2, 3}, .substeps = 5});
    const World copy = again(world);
    EXPECT_EQ(copy.gravity(), (Vec3{1, 2, 3}));
    EXPECT_EQ(copy.substeps(), 5);
}

}  // namespace
}  // namespace jostle::test
