// SPDX-License-Identifier: MIT
//
// Rollback: a world that goes back to a kept moment has its bits again, and takes the same way from
// there: mid-flight, asleep, after what was created and destroyed since.
#include "jostle/physics/restore_point.h"

#include <gtest/gtest.h>

#include <thread>

#include "physics/src/state/validate.h"
#include "physics/src/state/world_access.h"
#include "tests/support/test_scenes.h"

namespace jostle::test {
namespace {
using namespace physics;

RestorePoint kept(const World& world) {
    RestorePoint point;
    point.capture(world);
    return point;
}

void play(World& world, int step) {
    disturb(world, step);
    must(world.step(1.0 / 60));
}

// What a run looks like from outside, step by step.
struct Story {
    std::vector<std::uint64_t> hashes;
    std::vector<std::size_t> events;

    bool operator==(const Story&) const = default;
};

std::size_t count_events(const Events& e) {
    return e.contacts_began.size() + e.contacts_ended.size() + e.contacts.size() + e.hits.size() +
           e.triggers_entered.size() + e.triggers_stayed.size() + e.triggers_left.size() +
           e.joints_broke.size() + e.fell_asleep.size() + e.woke.size() + e.quarantined.size();
}

Story play_on(World& world, int from, int to) {
    Story story;
    for (int step = from; step < to; step++) {
        play(world, step);
        story.hashes.push_back(state_hash(world));
        story.events.push_back(count_events(world.events()));
    }
    return story;
}

class Rollback : public testing::TestWithParam<TestScene> {};

// From three moments, 90 steps there, back, there again and back again. Within them a body is
// created (120), one is destroyed (200) and many are pushed (300).
TEST_P(Rollback, replays_the_same_trajectory) {
    World world = GetParam().make(1);
    RestorePoint point;
    for (int step = 0; step < 420; step++) {
        if (step == 0 || step == 119 || step == 290) {
            point.capture(world);
            const std::uint64_t moment = state_hash(world);
            const Story first = play_on(world, step, step + 90);
            must(point.restore(world));
            ASSERT_EQ(state_hash(world), moment) << "step " << step;
            ASSERT_EQ(find_fault(state_of(world)).value_or(""), "") << "step " << step;
            ASSERT_EQ(play_on(world, step, step + 90), first) << "step " << step;
            must(point.restore(world));
        }
        play(world, step);
    }
    World straight = GetParam().make(1);
    for (int step = 0; step < 420; step++) play(straight, step);
    EXPECT_EQ(state_hash(world), state_hash(straight))
        << first_difference(world, straight).value_or("");
}

// Each step is played wrongly first: a body too many, one too few, a push, another step length.
TEST_P(Rollback, discards_mispredicted_steps) {
    World straight = GetParam().make(1), world = GetParam().make(1);
    RestorePoint point;
    for (int step = 0; step < 150; step++) {
        point.capture(world);
        add(world, {.position = {0.1 * (step % 7), 3, 0}, .velocity = {0, -20, 0}});
        const std::vector<BodyId> bodies = world.bodies();
        must(world.destroy_body(bodies[static_cast<std::size_t>(step) % bodies.size()]));
        disturb(world, 300);
        must(world.step(1.0 / 60));
        must(world.step(1.0 / 90));
        must(point.restore(world));
        play(world, step);
        play(straight, step);
        ASSERT_EQ(state_hash(world), state_hash(straight))
            << "step " << step << ": " << first_difference(world, straight).value_or("");
    }
}

TEST_P(Rollback, is_independent_of_the_thread_count) {
    World world = GetParam().make(2), other = GetParam().make(4);
    run(world, 1);
    const RestorePoint point = kept(world);
    run(world, 1);
    must(point.restore(other));
    run(other, 1);
    EXPECT_EQ(state_hash(world), state_hash(other)) << first_difference(world, other).value_or("");
}

// What a server does for a checkpoint: the world goes on while another thread makes bytes of it.
TEST_P(Rollback, can_be_saved_by_another_thread_while_the_world_steps) {
    World world = GetParam().make(1);
    run(world, 1);
    const std::vector<std::byte> expected = save(world);
    const std::uint64_t hash = state_hash(world);
    RestorePoint point = kept(world);
    RestorePoint::Saved saved;
    World spare = make_world();
    std::thread background([&] {
        saved = must(point.save());
        must(point.restore(spare));
    });
    for (int step = 0; step < 60; step++) play(world, step);
    background.join();
    EXPECT_TRUE(saved.bytes == expected)
        << saved.bytes.size() << " bytes against " << expected.size();
    EXPECT_EQ(saved.hash, hash);
    EXPECT_TRUE(save(spare) == expected);
    World loaded = must(load(saved.bytes));
    EXPECT_EQ(play_on(loaded, 0, 60).hashes.back(), state_hash(world));
}

INSTANTIATE_TEST_SUITE_P(scenes, Rollback, testing::ValuesIn(test_scenes()),
                         [](const auto& scene) { return scene.param.name; });

class RollbackBroadPhase : public testing::TestWithParam<BroadPhase> {};

World dropped_stack(BroadPhase kind) {
    World world = make_world({.broad_phase = kind});
    add_floor(world);
    for (int i = 0; i < 12; i++) add(world, {.position = {0.05 * i, 0.6 + 1.2 * i, 0}});
    return world;
}

TEST_P(RollbackBroadPhase, finds_the_same_pairs_and_ray_hits_after_restore) {
    World world = dropped_stack(GetParam());
    run(world, 0.5);
    const RestorePoint point = kept(world);
    const Ray ray{{-5, 0.4, 0}, {10, 0, 0}};
    const double before = must(world.queries().cast_ray(ray)).value().fraction;
    run(world, 2);
    const std::uint64_t later = state_hash(world);
    must(point.restore(world));
    EXPECT_EQ(must(world.queries().cast_ray(ray)).value().fraction, before);
    run(world, 2);
    EXPECT_EQ(state_hash(world), later);
}

// The moment brings its broad phase with it.
TEST_P(RollbackBroadPhase, restores_into_a_world_with_another_broad_phase) {
    World world = dropped_stack(GetParam()), other = make_world();
    run(world, 0.5);
    must(kept(world).restore(other));
    run(world, 2);
    run(other, 2);
    EXPECT_EQ(state_hash(world), state_hash(other)) << first_difference(world, other).value_or("");
}

INSTANTIATE_TEST_SUITE_P(kinds, RollbackBroadPhase,
                         testing::Values(BroadPhase::dynamic_tree, BroadPhase::sort_and_sweep,
                                         BroadPhase::uniform_grid));

TEST(RestorePointDetails, empty_point_is_rejected_and_changes_nothing) {
    World world = pyramid_scene();
    run(world, 0.5);
    const std::uint64_t before = state_hash(world);
    RestorePoint point;
    const Status refused = point.restore(world);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::failed_precondition);
    EXPECT_EQ(state_hash(world), before);
    point.capture(world);
    const RestorePoint taken = std::move(point);
    EXPECT_TRUE(point.empty());  // NOLINT(bugprone-use-after-move): that is what is asked
    EXPECT_FALSE(taken.empty());
}

TEST(RestorePointDetails, restore_invalidates_newer_ids_and_revives_older_ids) {
    World world = make_world();
    const BodyId old = add(world, {});
    const RestorePoint point = kept(world);
    must(world.destroy_body(old));
    const BodyId first = add(world, {}), second = add(world, {});
    must(point.restore(world));
    EXPECT_TRUE(world.contains(old));
    EXPECT_FALSE(world.contains(first));
    EXPECT_FALSE(world.contains(second));
    EXPECT_EQ(world.bodies().size(), 1u);
    EXPECT_EQ(add(world, {}), second);  // the lowest free id: `first` took the place of `old`
}

TEST(RestorePointDetails, sleeping_bodies_sleep_after_restore) {
    World world = make_world();
    add_floor(world);
    for (int i = 0; i < 4; i++) add(world, {.position = {0, 0.5 + i, 0}});
    run(world, 4);
    ASSERT_EQ(world.summary().awake_bodies, 0);
    const RestorePoint point = kept(world);
    const auto shoot = [&] {
        add(world, {.geometry = Sphere{0.4}, .position = {-3, 2.5, 0}, .velocity = {15, 0, 0}});
        run(world, 3);
        return state_hash(world);
    };
    const std::uint64_t first = shoot();
    must(point.restore(world));
    EXPECT_EQ(world.summary().awake_bodies, 0);
    EXPECT_EQ(world.bodies().size(), 5u);
    EXPECT_EQ(shoot(), first);
}

TEST(RestorePointDetails, events_are_replayed_after_restore) {
    World world = make_world();
    add_floor(world);
    const BodyId lower = add(world, {.position = {0, 0.5, 0}});
    add(world, {.position = {0, 1.5, 0}});
    run(world, 4);
    must(world.destroy_body(lower));  // its two contacts end; the next step is to say so
    const RestorePoint point = kept(world);
    must(world.step(1.0 / 60));
    ASSERT_EQ(world.events().contacts_ended.size(), 2u);
    run(world, 1);
    for (const BodyId body : world.bodies()) must(world.destroy_body(body));
    must(point.restore(world));
    EXPECT_EQ(count_events(world.events()), 0u);
    must(world.step(1.0 / 60));
    EXPECT_EQ(world.events().contacts_ended.size(), 2u);
}

// One hull of 14 corners for 50 bodies: each body of the world and of the point refers to it.
TEST(RestorePointDetails, geometry_is_shared_not_copied) {
    Random random(3);
    std::vector<Vec3> corners;
    for (int i = 0; i < 14; i++) corners.push_back(random.direction());
    const Hull hull{must(build_hull(corners))};
    World world = make_world();
    for (int i = 0; i < 50; i++) add(world, {.geometry = hull, .position = {3.0 * i, 0, 0}});
    EXPECT_EQ(hull.data.use_count(), 51);
    {
        RestorePoint point;
        for (int i = 0; i < 3; i++) point.capture(world);
        EXPECT_EQ(hull.data.use_count(), 101);
        world = make_world();  // a point does not need its world
        EXPECT_EQ(hull.data.use_count(), 51);
        must(point.restore(world));
        EXPECT_EQ(hull.data.use_count(), 101);
    }
    EXPECT_EQ(hull.data.use_count(), 51);
    EXPECT_EQ(world.bodies().size(), 50u);
}

TEST(RestorePointDetails, restore_keeps_the_thread_count) {
    World one = pyramid_scene(1), four = pyramid_scene(4);
    must(kept(one).restore(four));
    EXPECT_EQ(state_of(four).def.threads, 4);
    EXPECT_EQ(state_of(four).thread_pool->size(), 4);
}

TEST(RestorePointDetails, restores_gravity_and_substeps) {
    const World source = make_world({.gravity = {1, 2, 3}, .substeps = 5});
    World world = make_world();
    must(kept(source).restore(world));
    EXPECT_EQ(world.gravity(), (Vec3{1, 2, 3}));
    EXPECT_EQ(world.substeps(), 5);
    EXPECT_FALSE(first_difference(source, world));
}

}  // namespace
}  // namespace jostle::test
