// SPDX-License-Identifier: MIT
//
// A crowd is state: bit-identical results for any number of threads and after saving, loading and
// restoring. Untrusted bytes and settings are checked.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jostle/modules/character.h"
#include "tests/modules/crowd/people.h"
#include "tests/modules/module_determinism.h"
#include "tests/support/random.h"

namespace jostle::modules {
namespace {

using physics::BodyType;
using physics::Vec3;
using physics::World;

// People of all kinds, a flock, walls, goals, a threat and crates.
World lively(int threads) {
    static_cast<void>(physics::register_module("crowd", [] { return std::make_unique<Crowd>(); }));
    static_cast<void>(
        physics::register_module("character", [] { return std::make_unique<Characters>(); }));
    World world = test::make_world({.threads = threads});
    test::add_floor(world, 0.2);
    Crowd& crowd = add_crowd(world, {.seed = 7});
    auto owned = std::make_unique<Characters>();
    Characters& characters = *owned;
    test::must(world.add_module(std::move(owned)));
    test::must(crowd.add_wall({-6, 0}, {-1, 0}));
    test::must(crowd.add_wall({1, 0}, {6, 0}));
    test::must(crowd.set_routes({{0, 0}, {10, 10}, 0.5, 0.3}));
    test::must(crowd.add_goal({.areas = {{{0, 6}, {4, 1}}}, .end = GoalEnd::next, .next = 1}));
    test::must(crowd.add_goal({.areas = {{{-6, -6}}, {{6, -6}}}, .end = GoalEnd::leave}));
    test::must(crowd.add_flock({.roam = 8, .home = {0, 6, 0}}));
    for (int k = 0; k < 90; k++) {
        const Vec3 at{-5 + 0.7 * (k % 15), 0, -4 + 0.6 * (k / 15)};
        AgentDef def{.position = at, .slows_in_crowds = k % 2 == 0, .destination = to_goal(0)};
        if (k % 4 == 1) def.body = add_person(world, at);
        if (k % 4 == 2) def.body = add_person(world, at, BodyType::dynamic);
        if (k % 15 == 3) {
            const CharacterId id = test::must(characters.add(world, {.feet = at, .radius = 0.2}));
            def.body = test::must(characters.state(world, id)).body;
        }
        test::must(crowd.add(world, def));
    }
    test::Random random(3);
    for (int k = 0; k < 40; k++) {
        const Vec3 p = random.vector(2) + Vec3{0, 6, 0};
        const auto bird = test::must(world.create_body(
            {.type = BodyType::kinematic, .pose = {p, {}}, .linear_velocity = random.vector(2)},
            {.geometry = physics::Sphere{0.1}}));
        test::must(crowd.add(
            world,
            {.body = bird, .kind = AgentKind::flyer, .radius = 0.1, .speed = 3, .max_speed = 5}));
    }
    for (int k = 0; k < 6; k++)
        test::add(world, {.geometry = physics::Box{{0.2, 0.2, 0.2}},
                          .position = {-3 + k * 1.1, 0.21, 1.5},
                          .density = 200});
    const auto bull = test::add(world, {.geometry = physics::Sphere{0.4},
                                        .position = {-9, 0.4, -3},
                                        .velocity = {3, 0, 0},
                                        .type = BodyType::kinematic});
    test::must(crowd.add_threat(world, {bull, 3}));
    return world;
}

TEST(CrowdState, has_work_for_all_parts) {
    World world = lively(1);
    test::run(world, 3);
    EXPECT_GT(crowd_of(world).counts().panicked, 0u);
}

TEST(CrowdState, result_is_bit_identical_for_any_thread_count) {
    test::expect_same_for_threads(lively, 3);
}

TEST(CrowdState, result_is_bit_identical_for_any_instruction_set) {
    test::expect_same_for_instruction_sets(lively, 2);
}

TEST(CrowdState, continues_bit_identically_after_load_and_restore) {
    test::expect_continues(lively, 2, 4);
}

TEST(CrowdState, every_change_of_an_agent_changes_the_state) {
    World a = lively(1), b = lively(1);
    EXPECT_EQ(first_difference(a, b), std::nullopt);
    Crowd& crowd = crowd_of(b);
    test::must(crowd.set_destination(crowd.ids()[3], to_point({1e-9, 0, 0})));
    const auto difference = first_difference(a, b);
    ASSERT_TRUE(difference.has_value());
    EXPECT_THAT(*difference, testing::HasSubstr("crowd.state.agents[3].aim"));
}

// Any changed byte loads to values in range or is rejected.
TEST(CrowdState, rejects_corrupted_bytes) {
    World world = lively(1);
    test::run(world, 0.5);
    const std::vector<std::byte> good = save_module(crowd_of(world));
    Crowd copy;
    test::must(load_module(copy, good));
    EXPECT_EQ(save_module(copy), good);
    test::Random random(6);
    int refused = 0, taken = 0;
    for (int k = 0; k < 3000; k++) {
        std::vector<std::byte> corrupted = good;
        const int changes = 1 + static_cast<int>(random.below(3));
        for (int n = 0; n < changes; n++)
            corrupted[random.below(corrupted.size())] = static_cast<std::byte>(random.below(256));
        if (random.below(10) == 0) corrupted.resize(random.below(corrupted.size()));
        auto victim = std::make_unique<Crowd>();
        const physics::Status status = load_module(*victim, corrupted);
        status.ok() ? taken++ : refused++;
        if (!status.ok()) continue;
        ASSERT_EQ(save_module(*victim), corrupted);
        if (taken % 20 != 0) continue;
        World other = test::make_world();
        test::must(other.add_module(std::move(victim)));
        test::run(other, 0.1);
    }
    RecordProperty("refused", refused);
    RecordProperty("taken", taken);
    EXPECT_GT(refused, 500);
    EXPECT_GT(taken, 100);
}

// ---- settings of scenes ----

physics::Status configure(World& world, std::vector<std::pair<std::string, double>> numbers,
                          std::vector<std::pair<std::string, physics::BodyId>> bodies = {}) {
    return crowd_of(world).configure(world, {std::move(numbers), std::move(bodies)});
}

TEST(CrowdState, scene_settings_create_goals_walls_and_groups) {
    World world;
    test::add_floor(world);
    Crowd& crowd = add_crowd(world);
    test::must(configure(world, {{"seed", 3}, {"reach", 2}}));
    EXPECT_EQ(crowd.settings().seed, 3u);
    test::must(configure(world, {{"wall_from_x", -3}, {"wall_to_x", 3}, {"wall_to_z", 1}}));
    test::must(configure(world, {{"route_half_x", 10}, {"route_half_z", 10}, {"route_cell", 0.5}}));
    test::must(configure(world, {{"goal_center_z", 8}, {"goal_end", 1}}));
    test::must(configure(world, {{"goal_number", 0}, {"goal_center_z", -8}}));
    test::must(configure(world, {{"group_count", 40}, {"group_bodies", 1}, {"group_goal", 0}}));
    test::must(configure(world, {{"flock_reach", 4}}));
    test::must(configure(world, {{"group_count", 20},
                                 {"group_kind", 1},
                                 {"group_center_y", 6},
                                 {"group_half_y", 2},
                                 {"group_radius", 0.1}}));
    EXPECT_EQ(crowd.counts().agents, 60u);
    EXPECT_EQ(world.summary().dynamic_bodies, 40);
    test::run(world, 12);
    EXPECT_GT(crowd.counts().left, 10u);
}

TEST(CrowdState, scene_errors_name_the_setting) {
    World world;
    add_crowd(world);
    const auto error = [&](std::vector<std::pair<std::string, double>> numbers) {
        return configure(world, std::move(numbers)).error().message;
    };
    EXPECT_THAT(error({{"reach", 0}}), testing::HasSubstr("reach is 0; it must be from 0.2 to 50"));
    EXPECT_THAT(error({{"group_count", 20000}}), testing::HasSubstr("group_count is 20000"));
    EXPECT_THAT(error({{"group_count", 9999}, {"group_half_x", 1}, {"group_half_z", 1}}),
                testing::HasSubstr("has no room"));
    EXPECT_THAT(error({{"group_goal", 3}}), testing::HasSubstr("there are 0 goals"));
    EXPECT_THAT(error({{"goal_sentre_x", 3}}), testing::HasSubstr("unknown setting goal_sentre_x"));
    EXPECT_THAT(configure(world, {}, {{"obstacle_body", physics::BodyId{}}}).error().message,
                testing::HasSubstr("obstacle_body: "));
}

}  // namespace
}  // namespace jostle::modules
