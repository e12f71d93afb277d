// SPDX-License-Identifier: MIT
//
// What rests in an island that moves elsewhere stands still and costs nothing, and moves as soon as
// it would.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// A chain on a kinematic body that stands still falls asleep while that body stays in the awake
// set: in each of eight steps the parts of islands are looked at in another one.
TEST(PartialSleep, chain_on_a_stationary_kinematic_body_falls_asleep) {
    for (int shift = 0; shift < 8; shift++) {
        World world = make_world();
        add_floor(world);
        for (int step = 0; step < shift; step++) must(world.step(1.0 / 60));
        BodyId last = add(world, {.geometry = Box{{0.1, 0.1, 0.1}},
                                  .position = {0, 0.2, 0},
                                  .type = BodyType::kinematic});
        for (int k = 1; k <= 40; k++) {
            const BodyId next =
                add(world, {.geometry = Box{{0.2, 0.2, 0.2}}, .position = {0.5 * k, 0.2, 0}});
            must(world.create_joint({.body_a = last,
                                     .body_b = next,
                                     .frame_a = {{0.25, 0, 0}, {}},
                                     .frame_b = {{-0.25, 0, 0}, {}}}));
            last = next;
        }
        run(world, 2);
        EXPECT_FALSE(state_of(world, last).awake);
    }
}

// A wall of bricks, `rows` high, from the bottom, left to right; on its first column lies a small
// box that never sleeps and keeps the island awake.
struct GuardedWall {
    World world;
    std::vector<BodyId> bricks;
    BodyId guard;

    GuardedWall(int columns, int rows) : world(make_world()) {
        add_floor(world);
        const auto shift = [&](int row) { return columns > 1 ? 0.5 * (row % 2) : 0; };
        for (int r = 0; r < rows; r++)
            for (int c = 0; c < columns; c++)
                bricks.push_back(add(world, {.geometry = Box{{0.5, 0.25, 0.25}},
                                             .position = {c + shift(r), 0.25 + 0.5 * r, 0}}));
        guard = add(world, {.geometry = Box{{0.2, 0.2, 0.2}},
                            .position = {shift(rows - 1), 0.2 + 0.5 * rows, 0},
                            .sleep_allowed = false});
    }
    BodyId brick(int columns, int row, int column) const {
        return bricks[static_cast<std::size_t>(row * columns + column)];
    }
    bool awake(BodyId body) const { return must(world.body(body)).awake; }
    int asleep() const { return world.profile().bodies_asleep_in_place; }
};

TEST(PartialSleep, wall_sleeps_except_next_to_the_moving_body) {
    GuardedWall wall(10, 6);
    run(wall.world, 5);
    EXPECT_EQ(wall.world.profile().islands_awake, 1);
    EXPECT_GE(wall.asleep(), 58);
    EXPECT_LE(wall.world.profile().bodies_awake, 3);
    EXPECT_EQ(wall.world.summary().awake_bodies, wall.world.profile().bodies_awake);
    EXPECT_TRUE(wall.awake(wall.guard));
    EXPECT_TRUE(wall.awake(wall.brick(10, 5, 0)));
    EXPECT_FALSE(wall.awake(wall.brick(10, 5, 9)));
    // It may sleep as soon as nobody keeps it awake.
    must(wall.world.destroy_body(wall.guard));
    run(wall.world, 2);
    EXPECT_EQ(wall.world.summary().awake_bodies, 0);
}

TEST(PartialSleep, events_match_awake_states) {
    GuardedWall wall(10, 6);
    std::set<BodyId> asleep;
    for (int step = 0; step < 600; step++) {
        must(wall.world.step(1.0 / 60));
        for (const BodyId body : wall.world.events().woke) asleep.erase(body);
        for (const BodyId body : wall.world.events().fell_asleep) asleep.insert(body);
        if (step == 400)
            must(wall.world.apply_impulse(wall.brick(10, 5, 4), {0, 0, 300},
                                          position_of(wall.world, wall.brick(10, 5, 4))));
        // The impulse is felt in the step that follows, and told with it.
        if (step == 400) continue;
        for (const BodyId body : wall.bricks)
            ASSERT_EQ(wall.awake(body), !asleep.contains(body)) << "step " << step;
    }
    EXPECT_GE(asleep.size(), 30u);
}

TEST(PartialSleep, body_that_loses_its_support_falls_immediately) {
    GuardedWall wall(1, 24);
    run(wall.world, 5);
    ASSERT_GE(wall.asleep(), 16);
    const BodyId top = wall.bricks[20];
    ASSERT_FALSE(wall.awake(top));
    const double height = position_of(wall.world, top).y;
    must(wall.world.destroy_body(wall.bricks[8]));
    run(wall.world, 0.5);
    // A free fall of half a second is 1.2 m, and there is half a metre to fall.
    EXPECT_LT(position_of(wall.world, top).y, height - 0.4);
}

TEST(PartialSleep, load_change_wakes_a_sleeping_stack) {
    // A plank that juts out over the edge of a table by less than half, held down by bricks, bears
    // a stack at its free end.
    World world = make_world();
    add_floor(world);
    add(world, {.geometry = Box{{2, 1, 1}}, .position = {-2, 1, 0}, .type = BodyType::static_body});
    const BodyId plank = add(world, {.geometry = Box{{2, 0.1, 0.5}}, .position = {-0.2, 2.1, 0}});
    for (int k = 0; k < 10; k++)
        add(world, {.geometry = Box{{0.25, 0.1, 0.25}}, .position = {-1.9, 2.3 + 0.2 * k, 0}});
    for (int k = 0; k < 8; k++)
        add(world, {.geometry = Box{{0.25, 0.1, 0.25}}, .position = {1.5, 2.3 + 0.2 * k, 0}});
    add(world,
        {.geometry = Box{{0.1, 0.1, 0.1}}, .position = {-0.5, 2.3, 0}, .sleep_allowed = false});
    run(world, 6);
    ASSERT_GE(world.profile().bodies_asleep_in_place, 14);
    ASSERT_NEAR(position_of(world, plank).y, 2.1, 0.01);
    add(world, {.geometry = Box{{0.25, 0.25, 0.25}}, .position = {1.5, 4.05, 0}, .density = 8000});
    run(world, 2);
    EXPECT_LT(position_of(world, plank).y, 2.0);  // it has tipped
}

// Bricks in pairs, each welded to its neighbour; a kinematic arm that stands still holds the last.
TEST(PartialSleep, jointed_bodies_fall_asleep_and_wake_together) {
    GuardedWall wall(10, 6);
    std::vector<std::pair<BodyId, BodyId>> pairs;
    const auto weld = [&](BodyId a, BodyId b) {
        must(wall.world.create_joint({.body_a = a,
                                      .body_b = b,
                                      .frame_a = {.position = {0.5, 0, 0}},
                                      .frame_b = {.position = {-0.5, 0, 0}},
                                      .kind = FixedJoint{}}));
    };
    for (std::size_t k = 0; k < wall.bricks.size(); k += 2) {
        pairs.emplace_back(wall.bricks[k], wall.bricks[k + 1]);
        weld(wall.bricks[k], wall.bricks[k + 1]);
    }
    const BodyId last = wall.bricks.back();
    weld(last, add(wall.world, {.geometry = Box{{0.1, 0.1, 0.1}},
                                .position = position_of(wall.world, last) + Vec3{1, 0, 0},
                                .type = BodyType::kinematic}));
    run(wall.world, 5);
    EXPECT_GE(wall.asleep(), 50);
    EXPECT_TRUE(wall.awake(last)) << "what a kinematic body leads must follow it at once";
    const BodyId hit = wall.brick(10, 3, 5), mate = wall.brick(10, 3, 4);
    ASSERT_FALSE(wall.awake(hit));
    const Vec3 before = position_of(wall.world, mate);
    must(wall.world.apply_impulse(hit, {0, 0, 2500}, position_of(wall.world, hit)));
    EXPECT_TRUE(wall.awake(mate));
    for (int step = 0; step < 300; step++) {
        must(wall.world.step(1.0 / 60));
        for (const auto& [a, b] : pairs) ASSERT_EQ(wall.awake(a), wall.awake(b)) << "step " << step;
    }
    EXPECT_GT(length(position_of(wall.world, mate) - before), 0.1);
    EXPECT_GE(wall.asleep(), 30) << "and rests again";
}

// 64 boxes of a metre, four layers.
World block_of_boxes(bool sleeping) {
    World world = make_world({.sleeping = sleeping});
    add_floor(world);
    for (int layer = 0; layer < 4; layer++)
        for (int k = 0; k < 16; k++)
            add(world, {.position = {static_cast<double>(k % 4), 0.5 + layer,
                                     static_cast<double>(k / 4)}});
    return world;
}

enum class Rest { none, in_place, asleep };

// The momentum of all that moves, along x, just after a ball hit the block's side.
double momentum_after_hit(Rest rest) {
    World world = block_of_boxes(rest != Rest::none);
    if (rest != Rest::asleep)
        add(world,
            {.geometry = Box{{0.2, 0.2, 0.2}}, .position = {3.7, 0.2, 3}, .sleep_allowed = false});
    run(world, 5);
    EXPECT_EQ(world.profile().bodies_asleep_in_place > 40, rest == Rest::in_place);
    EXPECT_EQ(world.summary().awake_bodies == 0, rest == Rest::asleep);
    add(world, {.geometry = Sphere{0.5}, .position = {-2, 3.4, 1.5}, .velocity = {15, 0, 0}});
    run(world, 0.1);
    return world.summary().linear_momentum.x;
}

TEST(PartialSleep, impact_on_a_sleeping_block_equals_impact_on_an_awake_block) {
    const double awake = momentum_after_hit(Rest::none),
                 in_place = momentum_after_hit(Rest::in_place),
                 asleep = momentum_after_hit(Rest::asleep);
    RecordProperty("awake_kg_m_per_s", std::to_string(awake));
    RecordProperty("in_place_kg_m_per_s", std::to_string(in_place));
    RecordProperty("asleep_kg_m_per_s", std::to_string(asleep));
    EXPECT_NEAR(in_place, awake, 0.1 * awake);
    EXPECT_NEAR(asleep, awake, 0.1 * awake);
}

// A ball rolls against a corner of a block that sleeps: most of it never learns of that.
TEST(PartialSleep, small_impact_wakes_only_nearby_bodies_of_a_sleeping_block) {
    World world = block_of_boxes(true);
    run(world, 3);
    ASSERT_EQ(world.summary().awake_bodies, 0);
    add(world, {.geometry = Sphere{0.2},
                .position = {-1, 0.2, 0},
                .velocity = {0.5, 0, 0},
                .spin = {0, 0, -2.5}});
    int touched = 0, most = 0;
    std::set<BodyId> woken;
    for (int step = 0; step < 240; step++) {
        must(world.step(1.0 / 60));
        touched += static_cast<int>(world.events().contacts_began.size());
        most = std::max(most, world.profile().bodies_awake);
        for (const BodyId body : world.events().woke) woken.insert(body);
    }
    EXPECT_GE(touched, 1);
    EXPECT_GE(woken.size(), 1u);
    EXPECT_LE(woken.size(), 24u);
    EXPECT_LE(most, 25) << "the ball and what it stirred";
}

// In a wall that sleeps as a whole too.
TEST(PartialSleep, sleeping_body_that_loses_its_support_wakes_and_falls_immediately) {
    World world = make_world();
    add_floor(world);
    std::vector<BodyId> bricks;
    for (int k = 0; k < 24; k++)
        bricks.push_back(
            add(world, {.geometry = Box{{0.5, 0.25, 0.25}}, .position = {0, 0.25 + 0.5 * k, 0}}));
    run(world, 5);
    ASSERT_EQ(world.summary().awake_bodies, 0);
    const double height = position_of(world, bricks[20]).y;
    must(world.destroy_body(bricks[8]));
    run(world, 0.5);
    EXPECT_LT(position_of(world, bricks[20]).y, height - 0.4);
}

}  // namespace
}  // namespace jostle::test
