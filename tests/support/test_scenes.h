// SPDX-License-Identifier: MIT
//
// Small worlds with many interactions for bit-exact comparisons. They are independent of the scene
// catalogue, so that a change of a demo does not change golden hashes.
#pragma once

#include <string>
#include <vector>

#include "jostle/physics/profile.h"
#include "tests/support/random.h"
#include "tests/support/world_builder.h"

namespace jostle::test {

// Tests that compare worlds with one and several threads must use threads in every step.
inline const bool all_steps_are_shared = (physics::share_short_steps(true), true);

// 55 boxes at rest.
inline physics::World pyramid_scene(int threads = 1) {
    physics::World world = make_world({.threads = threads});
    add_floor(world);
    for (int i = 0; i < 10; i++)
        for (int j = 0; j < 10 - i; j++)
            add(world, {.position = {(j - (10 - i - 1) / 2.0) * 1.05, 0.5 + i, 0}});
    return world;
}

// Islands of every size class, which merge when the tall one is hit: a tower of 45 boxes, a load of
// 100 times the density on five boxes, a stack of three, and a ball that flies to the tower.
inline physics::World towers_scene(int threads = 1) {
    using namespace physics;
    World world = make_world({.threads = threads});
    add_floor(world);
    for (int k = 0; k < 45; k++) add(world, {.position = {0, 0.5 + k, 0}});
    for (int k = 0; k < 6; k++)
        add(world, {.position = {3, 0.5 + k, 0}, .density = k < 5 ? 1000.0 : 100000.0});
    for (int k = 0; k < 3; k++) add(world, {.position = {1.01, 0.5 + k, 0}});
    add(world, {.geometry = Sphere{0.5},
                .position = {-30, 3, 0},
                .velocity = {15, 8, 0.3},
                .density = 3000});
    return world;
}

inline void add_walls(physics::World& world, double half) {
    using namespace physics;
    for (int k = 0; k < 4; k++) {
        const double side = k % 2 == 0 ? half : -half;
        add(world, {.geometry = k < 2 ? Box{{0.2, 2, half}} : Box{{half, 2, 0.2}},
                    .position = k < 2 ? Vec3{side, 2, 0} : Vec3{0, 2, side},
                    .type = BodyType::static_body});
    }
}

inline physics::Geometry random_round_or_box(Random& random) {
    using namespace physics;
    const double a = random.in(0.15, 0.4), b = random.in(0.15, 0.4), c = random.in(0.15, 0.4);
    switch (random.below(3)) {
        case 0:
            return Sphere{a};
        case 1:
            return Capsule{a * 0.7, b};
        default:
            return Box{{a, b, c}};
    }
}

// 150 boxes, spheres and capsules fall into a walled yard.
inline physics::World pile_scene(int threads = 1) {
    physics::World world = make_world({.threads = threads});
    add_floor(world);
    add_walls(world, 3);
    Random random(21);
    for (int i = 0; i < 150; i++) {
        const physics::Vec3 position{random.in(-2, 2), 1 + 0.12 * i, random.in(-2, 2)};
        const physics::Geometry geometry = random_round_or_box(random);
        const physics::Quat rotation = random.rotation();
        const double restitution = i % 4 == 0 ? 0.5 : 0;
        add(world, {.geometry = geometry,
                    .position = position,
                    .rotation = rotation,
                    .spin = random.vector(3),
                    .friction = random.in(0.1, 0.9),
                    .restitution = restitution});
    }
    return world;
}

// Sleeping stacks, balls that hit them, a ramp, a sweeping kinematic bar, a body with three shapes
// and a damped one.
inline physics::World yard_scene(int threads = 1) {
    using namespace physics;
    World world = make_world({.threads = threads});
    add_floor(world, 0.6);
    add_walls(world, 8);
    Random random(33);
    for (int s = 0; s < 5; s++)
        for (int i = 0; i < 5; i++)
            add(world,
                {.geometry = Box{{0.4, 0.4, 0.4}}, .position = {s * 2.5 - 5, 0.4 + 0.8 * i, 3}});
    for (int i = 0; i < 6; i++)
        add(world, {.geometry = Sphere{0.4},
                    .position = {i * 2.2 - 5, 2 + 1.5 * i, -6.0 - 0.1 * i},
                    .velocity = {0, 0, 4.0 + i},
                    .restitution = 0.3,
                    .density = 3000});
    add(world, {.geometry = Box{{2, 0.1, 1}},
                .position = {4, 1, -3},
                .rotation = from_rotation_vector({0, 0, 0.4}),
                .type = BodyType::static_body});
    add(world, {.geometry = Box{{3, 0.2, 0.1}},
                .position = {-3, 0.5, -2},
                .spin = {0, 0.7, 0},
                .type = BodyType::kinematic});
    const BodyId hammer = must(world.create_body({.pose = {{2, 3, 0}, random.rotation()},
                                                  .angular_velocity = {1, 2, 3},
                                                  .linear_damping = 0.1,
                                                  .angular_damping = 0.2}));
    must(world.create_shape(hammer, {.geometry = Capsule{0.1, 0.8}}));
    must(world.create_shape(hammer, {.geometry = Box{{0.4, 0.2, 0.2}}, .pose = {{0, 0.9, 0}, {}}}));
    must(world.create_shape(hammer, {.geometry = Sphere{0.2}, .pose = {{0, -0.8, 0}, {}}}));
    for (int i = 0; i < 20; i++)
        add(world, {.geometry = random_round_or_box(random),
                    .position = {random.in(-6, 6), 4 + 0.5 * i, random.in(-2, 2)},
                    .friction = 0.4});
    return world;
}

// Features that the other scenes lack: a hilly mesh, hulls, cylinders, cones, compounds, joints of
// every kind with a motor, a trigger, a conveyor, rolling friction, locks, filter categories and
// bullets.
inline physics::World fair_scene(int threads = 1) {
    using namespace physics;
    World world = make_world({.threads = threads});
    Random random(55);
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    constexpr std::uint32_t side = 17;
    for (std::uint32_t r = 0; r < side; r++)
        for (std::uint32_t c = 0; c < side; c++)
            vertices.push_back({c * 1.0 - 8, random.in(-0.15, 0.15), r * 1.0 - 8});
    for (std::uint32_t r = 0; r + 1 < side; r++)
        for (std::uint32_t c = 0; c + 1 < side; c++) {
            const std::uint32_t v = r * side + c;
            triangles.push_back({v, v + side, v + 1});
            triangles.push_back({v + 1, v + side, v + side + 1});
        }
    add(world,
        {.geometry = Mesh{must(build_mesh(vertices, triangles))}, .type = BodyType::static_body});
    add_walls(world, 8);
    const BodyId belt =
        must(world.create_body({.type = BodyType::static_body, .pose = {{5, 0.6, 5}, {}}}));
    must(world.create_shape(
        belt, {.geometry = Box{{2, 0.1, 1}}, .material = {.surface_velocity = {-1, 0, 0.3}}}));
    std::vector<Vec3> stone;
    for (int i = 0; i < 14; i++) stone.push_back(random.direction() * 0.4);
    const Geometry hull = Hull{must(build_hull(stone))};
    const Geometry jack = Compound{must(build_compound({{Box{{0.5, 0.08, 0.08}}, {}},
                                                        {Box{{0.08, 0.5, 0.08}}, {}},
                                                        {Sphere{0.2}, {{0, 0, 0.3}, {}}}}))};
    const Geometry kinds[] = {hull, Cylinder{0.3, 0.25}, Cone{0.35, 0.4}, jack, Sphere{0.3}};
    for (int i = 0; i < 60; i++) {
        const Vec3 position{random.in(-6, 6), 1.5 + 0.25 * i, random.in(-6, 6)};
        // Evaluated one by one, because compilers differ in the evaluation order of arguments.
        const double friction = random.in(0.2, 0.9);
        const Quat rotation = random.rotation();
        const Vec3 spin = random.vector(4);
        must(world.create_body(
            {.pose = {position, rotation}, .angular_velocity = spin},
            {.geometry = kinds[i % 5],
             .material = {.friction = friction,
                          .restitution = i % 3 == 0 ? 0.4 : 0,
                          .rolling_friction = i % 5 == 4 ? 0.01 : 0,
                          .torsional_friction = 0.005},
             .filter = {.category = i % 7 == 0 ? 2u : 1u, .mask = i % 7 == 0 ? 1u : 3u},
             .report_stays = i == 0}));
    }
    BodyId above = add(
        world, {.geometry = Sphere{0.1}, .position = {-4, 5, -4}, .type = BodyType::static_body});
    for (int i = 0; i < 6; i++) {
        const BodyId link = add(world, {.geometry = Capsule{0.08, 0.2},
                                        .position = {-4 + 0.5 * i, 5, -4},
                                        .rotation = from_rotation_vector({0, 0, pi / 2})});
        const JointKind kind =
            i % 2 == 0 ? JointKind(BallJoint{})
                       : JointKind(ConeTwistJoint{
                             .swing = 0.7, .twist = {true, -0.3, 0.3}, .friction_torque = 0.5});
        must(world.create_joint({.body_a = above,
                                 .body_b = link,
                                 .frame_a = {i == 0 ? Vec3{} : Vec3{0, -0.25, 0},
                                             from_rotation_vector({0, 0, -pi / 2})},
                                 .frame_b = {{0, 0.25, 0}, from_rotation_vector({0, 0, -pi / 2})},
                                 .kind = kind}));
        above = link;
    }
    const BodyId post = add(
        world,
        {.geometry = Box{{0.1, 1, 0.1}}, .position = {3, 1, -4}, .type = BodyType::static_body});
    const BodyId arm =
        must(world.create_body({.pose = {{3.8, 1.5, -4}, {}}}, {.geometry = Box{{0.7, 0.1, 0.1}}}));
    must(world.create_joint({.body_a = post,
                             .body_b = arm,
                             .frame_a = {{0, 0.5, 0}, from_rotation_vector({pi / 2, 0, 0})},
                             .frame_b = {{-0.8, 0, 0}, from_rotation_vector({pi / 2, 0, 0})},
                             .kind = HingeJoint{.motor = {true, 2, 200}}}));
    const BodyId pair_a = add(world, {.geometry = Box{{0.2, 0.2, 0.2}}, .position = {0, 4, 6}});
    const BodyId pair_b = add(world, {.geometry = Box{{0.2, 0.2, 0.2}}, .position = {0.6, 4, 6}});
    must(world.create_joint({.body_a = pair_a,
                             .body_b = pair_b,
                             .frame_a = {{0.6, 0, 0}, {}},
                             .kind = FixedJoint{.angular = {8, 0.5}},
                             .break_force = 3e4}));
    must(world.create_joint(
        {.body_a = pair_b,
         .body_b = arm,
         .kind = DistanceJoint{
             .min_length = 0.5, .max_length = 12, .spring = {0.7, 0.2}, .rest_length = 4}}));
    must(world.create_body(
        {.pose = {{-6, 0.7, 0}, {}}, .locks = lock_z | lock_rotation_x | lock_rotation_y},
        {.geometry = Box{{0.4, 0.3, 0.4}}}));
    must(world.create_body({.type = BodyType::static_body, .pose = {{0, 1, 0}, {}}},
                           {.geometry = Sphere{2}, .trigger = true}));
    for (int i = 0; i < 4; i++)
        add(world, {.geometry = Box{{0.06, 0.03, 0.03}},
                    .position = {-7.5, 1.2 + 0.4 * i, -3.0 + 2 * i},
                    .velocity = {150.0 + 20 * i, 0, 3},
                    .spin = {0, 20, 50},
                    .density = 6000});
    return world;
}

// 310 chains of two links that swing through each other, with joints of all kinds, with and without
// limits, springs and motors. The joint levels are long enough for several threads.
inline physics::World chains_scene(int threads = 1) {
    using namespace physics;
    World world = make_world({.threads = threads});
    Random random(77);
    const BodyId ceiling = add(
        world, {.geometry = Sphere{0.1}, .position = {0, 12, 0}, .type = BodyType::static_body});
    for (int i = 0; i < 310; i++) {
        const bool plain = i < 260;  // ball joints; the other chains use all kinds
        const JointKind kinds[] = {
            BallJoint{},
            HingeJoint{.limit = {i % 2 == 0, -0.4, 0.6}, .motor = {i % 3 == 0, 2, 15}},
            HingeJoint{.spring = {2, 0.3}, .spring_angle = 0.5},
            ConeTwistJoint{
                .swing = 0.5, .twist = {i % 2 == 0, -0.2, 0.3}, .friction_torque = i % 3 * 0.4},
            FixedJoint{.angular = {i % 2 * 3.0, 0.2}},
            DistanceJoint{.min_length = 0.2, .max_length = i % 2 == 0 ? 0.2 : 0.5},
            DistanceJoint{
                .min_length = 0, .max_length = 2, .spring = {3, 0.1}, .rest_length = 0.3}};
        BodyId above = ceiling;
        Vec3 position{i % 20 - 9.5, 0, i / 20 - 9.5};
        Vec3 anchor = position;
        for (int link = 0; link < 2; link++) {
            position.y = -0.5 * link;
            const Vec3 spin = random.vector(2);
            const BodyId body = must(world.create_body(
                {.pose = {position + Vec3{0, 11.6, 0}, {}}, .angular_velocity = spin},
                {.geometry = Capsule{0.06, 0.15}, .filter = {.mask = 0}}));
            must(world.create_joint(
                {.body_a = above,
                 .body_b = body,
                 .frame_a = {anchor, from_rotation_vector({0, 0, -pi / 2})},
                 .frame_b = {{0, 0.25, 0}, from_rotation_vector({0, 0.1 * link, -pi / 2})},
                 .kind = kinds[plain ? 0 : i % 7]}));
            above = body;
            anchor = {0, -0.25, 0};
        }
    }
    return world;
}

// A block of bodies of three kinds, some with joints to their neighbours, and a small body on top
// that never sleeps. Most of the block is frozen, and disturbances thaw parts of it.
inline physics::World guarded_scene(int threads = 1) {
    using namespace physics;
    World world = make_world({.threads = threads});
    add_floor(world);
    for (int i = 0; i < 108; i++) {
        const Vec3 position{i % 6 - 2.5, 0.5 + i / 36, i / 6 % 6 - 2.5};
        const bool on_top = i >= 72;
        if (on_top && i % 5 == 0)
            add(world, {.geometry = Cylinder{0.5, 0.5}, .position = position});
        else if (on_top && i % 7 == 0)
            must(world.create_body(
                {.pose = {position, {}}},
                {.geometry = Sphere{0.5}, .material = {.rolling_friction = 0.1}}));
        else
            add(world, {.position = position});
        if (i % 6 != 3 || i % 4 == 0) continue;
        const std::vector<BodyId> bodies = world.bodies();
        const JointKind kinds[] = {FixedJoint{}, BallJoint{}, HingeJoint{}};
        must(world.create_joint({.body_a = bodies[bodies.size() - 2],
                                 .body_b = bodies.back(),
                                 .frame_a = {{0.5, 0, 0}, {}},
                                 .frame_b = {{-0.5, 0, 0}, {}},
                                 .kind = kinds[i / 6 % 3]}));
    }
    add(world,
        {.geometry = Box{{0.2, 0.2, 0.2}}, .position = {2.4, 3.2, 2.5}, .sleep_allowed = false});
    return world;
}

// 225 stacks of three: enough small islands that the solver groups them into batches. A heavy ball
// rolls through them, so that islands of different batches merge; a kinematic plough pushes some,
// and a rope lies on others.
inline physics::World village_scene(int threads = 1) {
    using namespace physics;
    World world = make_world({.threads = threads});
    add_floor(world);
    const Geometry brick = Box{{0.3, 0.2, 0.3}};
    for (int s = 0; s < 225; s++)
        for (int k = 0; k < 3; k++)
            add(world, {.geometry = brick,
                        .position = {s % 15 * 1.5 - 10.5, 0.2 + 0.4 * k, s / 15 * 1.5 - 10.5}});
    add(world, {.geometry = Sphere{0.5},
                .position = {-14, 0.5, -9},
                .velocity = {12, 0, 8},
                .density = 8000});
    add(world, {.geometry = Box{{2, 0.3, 0.1}},
                .position = {5, 0.4, 14},
                .velocity = {0, 0, -1},
                .type = BodyType::kinematic});
    BodyId above = add(
        world, {.geometry = Capsule{0.1, 0.2}, .position = {-6, 2, 6}, .rotation = {0, 0, 1, 1}});
    for (int k = 1; k < 8; k++) {
        const BodyId link = add(world, {.geometry = Capsule{0.1, 0.2},
                                        .position = {-6 + 0.5 * k, 2, 6},
                                        .rotation = {0, 0, 1, 1}});
        must(world.create_joint({.body_a = above,
                                 .body_b = link,
                                 .frame_a = {{0, -0.25, 0}, {}},
                                 .frame_b = {{0, 0.25, 0}, {}},
                                 .kind = BallJoint{}}));
        above = link;
    }
    return world;
}

struct TestScene {
    std::string name;
    physics::World (*make)(int threads);
};

inline const std::vector<TestScene>& test_scenes() {
    static const std::vector<TestScene> all = {
        {"pyramid", pyramid_scene}, {"pile", pile_scene},      {"towers", towers_scene},
        {"yard", yard_scene},       {"fair", fair_scene},      {"chains", chains_scene},
        {"guarded", guarded_scene}, {"village", village_scene}};
    return all;
}

// Changes that callers make while a world runs, always at the same steps.
inline void disturb(physics::World& world, int step) {
    using namespace physics;
    if (step == 120) add(world, {.position = {0.3, 12, 0.2}, .velocity = {0, -10, 0}});
    if (step == 200) {
        const std::vector<BodyId> bodies = world.bodies();
        must(world.destroy_body(bodies[bodies.size() / 2]));
    }
    if (step == 300)
        for (const BodyId body : world.bodies())
            if (state_of(world, body).type == BodyType::dynamic && body.index % 7 == 0)
                must(world.apply_impulse(body, {30, 200, -20}, state_of(world, body).center));
}

}  // namespace jostle::test
