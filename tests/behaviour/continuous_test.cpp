// SPDX-License-Identifier: MIT
//
// Continuous collision: nothing passes, whatever it is and however it turns, and the time after an
// impact is lived.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/near.h"
#include "tests/support/random.h"
#include "tests/support/random_shapes.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

// 1000 balls at 200 m/s and a wall of 5 cm, for each of 16 phases of the step.
TEST(Continuous, no_ball_of_a_thousand_tunnels_through_a_thin_wall) {
    for (int phase = 0; phase < 16; phase++) {
        World world = make_world({.gravity = {}});
        add(world, {.geometry = Box{{0.025, 10, 10}}, .type = BodyType::static_body});
        Random random(77);
        std::vector<BodyId> balls;
        for (int i = 0; i < 1000; i++)
            balls.push_back(
                add(world, {.geometry = Sphere{0.1},
                            .position = {random.in(-15, -5) - phase * 200.0 / 60 / 16,
                                         ((i % 32) - 15.5) * 0.5, ((i / 32) - 15.5) * 0.5},
                            .velocity = {200, 0, 0}}));
        run(world, 0.15);
        int passed = 0;
        for (const BodyId ball : balls) passed += position_of(world, ball).x > 0 ? 1 : 0;
        EXPECT_EQ(passed, 0) << "phase " << phase;
    }
}

// A rod of 2 m that turns 10 rad in a step of 1/60 s, beside a post of 2 cm within its reach: it
// stops at the post or bounces, but is never on the other side without having touched it.
TEST(Continuous, spinning_rod_does_not_tunnel_through_a_post) {
    for (const double spin : {30.0, 100.0, 600.0}) {
        World world = make_world({.gravity = {}});
        add(world, {.geometry = Box{{0.01, 1, 0.01}},
                    .position = {0, 0, 0.8},
                    .type = BodyType::static_body});
        const BodyId rod = add(world, {.geometry = Box{{1, 0.02, 0.02}}, .spin = {0, -spin, 0}});
        int hits = 0;
        for (int i = 0; i < 30; i++) {
            must(world.step(1.0 / 60));
            hits += static_cast<int>(world.events().hits.size());
        }
        EXPECT_GT(hits, 0) << spin << " rad/s";
        EXPECT_LT(std::fabs(state_of(world, rod).angular_velocity.y), 0.5 * spin)
            << spin << " rad/s: the post took its spin";
    }
}

// Head on, 400 m/s closing speed, meeting in the middle of a step: they bounce as elastic balls do.
TEST(Continuous, two_bullets_collide) {
    for (int phase = 0; phase < 8; phase++) {
        World world = make_world({.gravity = {}});
        const double shift = phase * 200.0 / 60 / 8;
        const BodyId a = add(world, {.geometry = Sphere{0.02},
                                     .position = {-10 - shift, 0, 0},
                                     .velocity = {200, 0, 0},
                                     .restitution = 1});
        const BodyId b = add(world, {.geometry = Sphere{0.02},
                                     .position = {10 + shift, 0, 0},
                                     .velocity = {-200, 0, 0},
                                     .restitution = 1});
        run(world, 0.2);
        EXPECT_NEAR(velocity_of(world, a).x, -200, 0.1) << phase;
        EXPECT_NEAR(velocity_of(world, b).x, 200, 0.1) << phase;
    }
}

// A ball that bounces off a wall in mid-step is where the mirror says, not at the wall.
TEST(Continuous, time_after_the_impact_is_simulated) {
    for (int phase = 0; phase < 16; phase++) {
        World world = make_world({.gravity = {}});
        add(world,
            {.geometry = Box{{0.5, 5, 5}}, .position = {0.5, 0, 0}, .type = BodyType::static_body});
        const double start = -5 - phase * 0.1;
        const BodyId ball = add(world, {.geometry = Sphere{0.05},
                                        .position = {start, 0, 0},
                                        .velocity = {100, 0, 0},
                                        .restitution = 1});
        const int steps = 6;
        for (int i = 0; i < steps; i++) must(world.step(1.0 / 60));
        const double way = 100.0 * steps / 60, to_wall = -0.05 - start;
        EXPECT_NEAR(position_of(world, ball).x, -0.05 - (way - to_wall), 0.01) << phase;
    }
}

// One end of a plank meets a sheet of a centimetre, a plane or a mesh, and within the same step the
// other end comes down on it.
void throw_plank(const Geometry& ground) {
    for (int phase = 0; phase < 16; phase++)
        for (const double speed : {11.0, 40.0, 90.0}) {
            World world = make_world({.gravity = {}});
            add(world, {.geometry = ground, .type = BodyType::static_body});
            const BodyId plank = add(world, {.geometry = Box{{1, 0.05, 0.2}},
                                             .position = {0, 1 + phase * speed / 60 / 16, 0},
                                             .rotation = from_rotation_vector({0, 0, 0.2}),
                                             .velocity = {0, -speed, 0}});
            double deepest = 0;
            for (int i = 0; i < 20; i++) {
                must(world.step(1.0 / 60));
                deepest = std::max(deepest, world.summary().max_penetration);
                ASSERT_GT(position_of(world, plank).y, 0) << speed << " m/s, phase " << phase;
            }
            EXPECT_LT(deepest, 0.02) << speed << " m/s, phase " << phase;
        }
}
TEST(Continuous, end_of_a_plank_does_not_tunnel) {
    throw_plank(Box{{5, 0.005, 5}});
    throw_plank(Plane{});
    const std::vector<Vec3> vertices{{-5, 0, -5}, {5, 0, -5}, {5, 0, 5}, {-5, 0, 5}, {0.1, 0, 0.2}};
    const std::vector<std::array<std::uint32_t, 3>> triangles{
        {0, 4, 1}, {1, 4, 2}, {2, 4, 3}, {3, 4, 0}};
    throw_plank(Mesh{must(build_mesh(vertices, triangles))});
}

// Thin rods that tumble fast lose energy at walls and posts, and never gain any.
TEST(Continuous, tumbling_rods_gain_no_energy) {
    Random random(12);
    for (int i = 0; i < 60; i++) {
        World world = make_world({.gravity = {}});
        for (const double x : {-3.0, 3.0})
            add(world, {.geometry = Box{{0.05, 5, 5}},
                        .position = {x, 0, 0},
                        .type = BodyType::static_body});
        add(world, {.geometry = Box{{0.01, 5, 0.01}},
                    .position = {0.7, 0, 0},
                    .type = BodyType::static_body});
        add(world, {.geometry = Box{{1, 0.03, 0.03}},
                    .position = {-1.2, random.in(-1, 1), random.in(-1, 1)},
                    .rotation = random.rotation(),
                    .velocity = random.vector(40),
                    .spin = random.vector(120)});
        double before = world.summary().kinetic_energy;
        for (int step = 0; step < 40; step++) {
            must(world.step(1.0 / 60));
            const double now = world.summary().kinetic_energy;
            ASSERT_LE(now, before * 1.01) << "rod " << i << ", step " << step;
            before = now;
        }
    }
}

// Six times to and fro between two sheets of a centimetre in every step: what is behind the ball
// when the step begins is in its way as well.
TEST(Continuous, ball_stays_between_two_thin_walls) {
    World world = make_world({.gravity = {}});
    for (const double x : {-0.3, 0.3})
        add(world,
            {.geometry = Box{{0.005, 5, 5}}, .position = {x, 0, 0}, .type = BodyType::static_body});
    const BodyId ball = add(world, {.geometry = Sphere{0.05},
                                    .position = {0.1, 0, 0},
                                    .velocity = {200, 0, 0},
                                    .restitution = 1});
    for (int i = 0; i < 60; i++) {
        must(world.step(1.0 / 60));
        ASSERT_LT(std::fabs(position_of(world, ball).x), 0.25) << "step " << i;
        ASSERT_NEAR(std::fabs(velocity_of(world, ball).x), 200, 1e-6);
    }
}

// A room whose walls are 2 cm thick, and in it shapes of every kind at up to 170 m/s and 100 rad/s:
// off walls, each other and corners they fly, tumble and bounce, but not out.
TEST(Continuous, no_body_escapes_a_room) {
    static constexpr ShapeKind kinds[] = {ShapeKind::sphere,   ShapeKind::capsule, ShapeKind::box,
                                          ShapeKind::cylinder, ShapeKind::cone,    ShapeKind::hull};
    for (const double restitution : {0.0, 0.9}) {
        World world = make_world({.gravity = {}});
        for (int axis = 0; axis < 3; axis++)
            for (const double side : {-6.0, 6.0}) {
                Vec3 position, half{6.2, 6.2, 6.2};
                position[axis] = side;
                half[axis] = 0.01;
                add(world, {.geometry = Box{half},
                            .position = position,
                            .restitution = restitution,
                            .type = BodyType::static_body});
            }
        Random random(7);
        for (int i = 0; i < 60; i++)
            add(world, {.geometry = random_geometry(kinds[i % 6], random),
                        .position = random.vector(4),
                        .rotation = random.rotation(),
                        .velocity = random.vector(100),
                        .spin = random.vector(60),
                        .restitution = restitution});
        run(world, 1);
        for (const BodyId body : world.bodies()) {
            const Vec3 p = state_of(world, body).center;
            EXPECT_LE(std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)}), 6);
        }
    }
}

// Bodies of two shapes in one place: each impact changed the candidates of all others, and a step
// with 2.8 million sweeps took ten seconds.
TEST(Continuous, crowd_of_overlapping_bodies_has_few_sweeps) {
    World world = make_world();
    add_floor(world);
    for (int i = 0; i < 100; i++) {
        const BodyId body = add(world, {.position = {0.0005 * i, 0.6, 0}});
        must(world.create_shape(body, {.geometry = Sphere{0.4}, .pose = {.position = {1, 0, 0}}}));
    }
    int most = 0;
    for (int step = 0; step < 30; step++) {
        must(world.step(1.0 / 60));
        most = std::max(most, world.profile().sweeps);
    }
    EXPECT_GT(most, 16'384 + 16 * 100) << "the limit is reached";
    EXPECT_LT(most, 100'000);
}

// A ball of half a metre comes back from a wall and catches up with a plate of two centimetres in
// the same step, by 9 cm: little for the ball, much for the plate. The ball, which turned last,
// looks for both, and must look as the plate would: they are never half a centimetre in each other.
TEST(Continuous, rotating_thick_body_is_swept_like_a_thin_one) {
    for (const bool ball_first : {false, true}) {
        World world = make_world({.gravity = {}});
        add(world, {.geometry = Box{{1, 2, 2}},
                    .position = {-1, 0, 0},
                    .restitution = 0.17,
                    .type = BodyType::static_body});
        const BuiltBody thick{
            .geometry = Sphere{0.5}, .position = {0.567, 0, 0}, .velocity = {-40, 0, 0}};
        const BuiltBody thin{
            .geometry = Box{{0.01, 1, 1}}, .position = {1.08, 0, 0}, .velocity = {1, 0, 0}};
        const BodyId first = add(world, ball_first ? thick : thin),
                     second = add(world, ball_first ? thin : thick);
        for (int step = 0; step < 4; step++) {
            must(world.step(1.0 / 60));
            const double gap =
                std::fabs(position_of(world, first).x - position_of(world, second).x) - 0.51;
            EXPECT_GT(gap, -0.005)
                << "step " << step << (ball_first ? ", ball" : ", plate") << " first";
        }
    }
}

// Balls of 3 to 20 cm on one line, which bounce off each other at 60 m/s and more: in every step
// dozens turn round, and whoever was to meet them must know; light ones between heavy ones have
// more impacts than a step allows. Nobody passes anybody, and no energy is lost.
TEST(Continuous, colliding_beads_keep_their_order) {
    constexpr int count = 59;
    for (const unsigned seed : {1u, 2u, 3u}) {
        World world = make_world({.gravity = {}});
        for (const double end : {-32.0, 32.0})
            add(world, {.geometry = Box{{1, 1, 1}},
                        .position = {end, 0, 0},
                        .friction = 0,
                        .restitution = 1,
                        .type = BodyType::static_body});
        Random random(seed);
        std::vector<BodyId> beads(count);
        // Made in an order that has nothing to do with where they are.
        for (int i = 0; i < count; i++) {
            const int place = i * 23 % count;
            const double radius = random.in(0.03, 0.2);
            beads[static_cast<std::size_t>(place)] =
                add(world, {.geometry = Sphere{radius},
                            .position = {place - 29.0, 0, 0},
                            .velocity = {random.in(-60, 60), 0, 0},
                            .friction = 0,
                            .restitution = 1});
        }
        const auto energy = [&] {
            double sum = 0;
            for (const BodyId bead : beads)
                sum += state_of(world, bead).mass * length_squared(velocity_of(world, bead)) / 2;
            return sum;
        };
        const double at_start = energy();
        std::size_t hits = 0;
        for (int step = 0; step < 300; step++) {
            must(world.step(1.0 / 60));
            hits += world.events().hits.size();
            double last = -31;
            for (const BodyId bead : beads) {
                const double x = position_of(world, bead).x;
                ASSERT_GT(x, last) << "seed " << seed << ", step " << step;
                last = x;
            }
            ASSERT_LT(last, 31);
        }
        EXPECT_GT(hits, 6000u);
        EXPECT_NEAR(energy() / at_start, 1, 0.01) << "seed " << seed;
    }
}

// A bullet into a crate that stands free: momentum goes over in full.
TEST(Continuous, dynamic_target_receives_the_momentum) {
    World world = make_world({.gravity = {}});
    const BodyId crate = add(world, {.geometry = Box{{0.02, 0.5, 0.5}}});
    const BodyId bullet = add(world, {.geometry = Sphere{0.03},
                                      .position = {-7.3, 0, 0},
                                      .velocity = {300, 0, 0},
                                      .density = 8000});
    const double before = 300 * state_of(world, bullet).mass;
    run(world, 0.1);
    const BodyState c = state_of(world, crate), b = state_of(world, bullet);
    EXPECT_NEAR(c.mass * c.linear_velocity.x + b.mass * b.linear_velocity.x, before, 1e-6 * before);
    EXPECT_GT(c.linear_velocity.x, b.linear_velocity.x - 1e-3) << "it did not pass through";
    EXPECT_GT(c.pose.position.x, b.pose.position.x);
}

// A sleeping target wakes.
// A ball rests a metre before a sheet of 1 cm; a bullet throws it at that, both within one step.
TEST(Continuous, body_hit_by_a_bullet_stops_at_the_wall_behind) {
    for (const bool asleep : {false, true}) {
        for (int phase = 0; phase < 16; phase++) {
            World world = make_world({.gravity = {}});
            add(world, {.geometry = Box{{0.005, 5, 5}}, .type = BodyType::static_body});
            const BodyId ball = add(world, {.geometry = Sphere{0.1}, .position = {-1, 0, 0}});
            if (asleep) run(world, 1);
            ASSERT_EQ(state_of(world, ball).awake, !asleep);
            const BodyId bullet = add(world, {.geometry = Sphere{0.1},
                                              .position = {-3 - phase * 200.0 / 60 / 16, 0, 0},
                                              .velocity = {200, 0, 0}});
            run(world, 0.1);
            EXPECT_LT(position_of(world, ball).x, 0) << "phase " << phase;
            EXPECT_LT(position_of(world, bullet).x, 0) << "phase " << phase;
        }
    }
}

TEST(Continuous, bullet_wakes_the_body_it_hits) {
    World world = make_world();
    add_floor(world);
    const BodyId box = add(world, {.position = {0, 0.5, 0}});
    run(world, 2);
    ASSERT_FALSE(state_of(world, box).awake);
    add(world, {.geometry = Sphere{0.05},
                .position = {-20, 0.5, 0.1},
                .velocity = {250, 0, 0},
                .density = 8000});
    run(world, 0.2);
    EXPECT_TRUE(state_of(world, box).awake);
    EXPECT_GT(velocity_of(world, box).x, 0.05);
}

// A kinematic blade that turns fast bats a ball away instead of passing it.
TEST(Continuous, kinematic_blade_bats_a_ball) {
    World world = make_world({.gravity = {}});
    const BodyId blade = add(
        world, {.geometry = Box{{1, 0.5, 0.01}}, .spin = {0, 40, 0}, .type = BodyType::kinematic});
    const BodyId ball = add(world, {.geometry = Sphere{0.05}, .position = {0, 0, 0.7}});
    run(world, 0.2);
    EXPECT_GT(length(velocity_of(world, ball)), 10);
    EXPECT_EQ(state_of(world, blade).angular_velocity, (Vec3{0, 40, 0}));
}

TEST(Continuous, thin_mesh_stops_bullets) {
    const std::vector<Vec3> vertices{{0, -5, -5}, {0, 5, -5}, {0, 5, 5}, {0, -5, 5}};
    const std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 2}, {0, 2, 3}};
    for (int phase = 0; phase < 16; phase++) {
        World world = make_world({.gravity = {}});
        add(world, {.geometry = Mesh{must(build_mesh(vertices, triangles))},
                    .type = BodyType::static_body});
        const BodyId bullet = add(world, {.geometry = Box{{0.03, 0.02, 0.02}},
                                          .position = {-5 - phase * 0.2, 0.3, 0.3},
                                          .velocity = {200, 3, 1},
                                          .spin = {5, 90, 40}});
        run(world, 0.3);
        EXPECT_LT(position_of(world, bullet).x, 0) << phase;
    }
}

// Chains of six capsules at 10 to 30 m/s, up to half a metre a step, against a plate or a sheet of
// triangles: a link that meets it takes the others along by its joints in that same step. Stopped
// by a sweep of its own it is torn 26 cm off. What counts is the mean of the chains: which of them
// parts furthest is chance.
TEST(Continuous, chain_that_hits_a_wall_stays_connected) {
    constexpr int links = 6;
    const std::vector<Vec3> vertices{{0, -9, -9}, {0, 9, -9}, {0, 9, 9}, {0, -9, 9}};
    const std::vector<std::array<std::uint32_t, 3>> triangles{{0, 1, 2}, {0, 2, 3}};
    const Geometry sheet = Mesh{must(build_mesh(vertices, triangles))};
    const Geometry plate = Box{{0.01, 9, 9}};
    constexpr int trials = 100;
    double worst = 0, sum = 0, deepest = -10;
    Random random(12);
    for (int trial = 0; trial < trials; trial++) {
        World world = make_world({.gravity = {}});
        add(world, {.geometry = trial % 2 == 0 ? plate : sheet, .type = BodyType::static_body});
        const Quat turn =
            from_rotation_vector({random.in(-3, 3), random.in(-3, 3), random.in(-3, 3)});
        const Vec3 along = rotate(turn, {0, 1, 0}), start{-3.5, random.in(-1, 1), random.in(-1, 1)};
        const Vec3 velocity{random.in(10, 30), random.in(-10, 10), 0};
        std::vector<BodyId> chain;
        std::vector<JointId> joints;
        for (int i = 0; i < links; i++) {
            chain.push_back(add(world, {.geometry = Capsule{0.06, 0.15},
                                        .position = start + along * (0.45 * i),
                                        .rotation = turn,
                                        .velocity = velocity}));
            if (i == 0) continue;
            joints.push_back(must(world.create_joint({.body_a = chain[chain.size() - 2],
                                                      .body_b = chain.back(),
                                                      .frame_a = {{0, 0.225, 0}, {}},
                                                      .frame_b = {{0, -0.225, 0}, {}},
                                                      .kind = BallJoint{}})));
        }
        double apart = 0;  // at worst
        for (int step = 0; step < 30; step++) {
            must(world.step(1.0 / 60));
            for (const JointId joint : joints)
                apart = std::max(apart, must(world.joint(joint)).separation);
            for (const BodyId link : chain) deepest = std::max(deepest, position_of(world, link).x);
        }
        worst = std::max(worst, apart);
        sum += apart;
    }
    EXPECT_LT(sum / trials, 0.02);
    EXPECT_LT(worst, 0.2);
    EXPECT_LT(deepest, 0) << "no link passed";
}

}  // namespace
}  // namespace jostle::test
