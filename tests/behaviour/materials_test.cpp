// SPDX-License-Identifier: MIT
//
// Combining rules, rolling and torsional friction, conveyors, filters, locks, damping.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

BodyId add_with(World& world, const BuiltBody& part, const Material& material, Filter filter = {}) {
    return must(world.create_body({.type = part.type,
                                   .pose = {part.position, part.rotation},
                                   .linear_velocity = part.velocity,
                                   .angular_velocity = part.spin},
                                  {.geometry = part.geometry,
                                   .material = material,
                                   .density = part.density,
                                   .filter = filter}));
}

// How far a box slides at 4 m/s tells the coefficient of the pair.
double friction_of_pair(const Material& box, const Material& ground) {
    World world = make_world();
    add_with(world, {.geometry = Plane{}, .type = BodyType::static_body}, ground);
    const BodyId slider = add_with(
        world, {.geometry = Box{{0.5, 0.1, 0.5}}, .position = {0, 0.1, 0}, .velocity = {4, 0, 0}},
        box);
    run(world, 6);
    return 16 / (2 * 9.81 * position_of(world, slider).x);
}

TEST(Materials, friction_uses_the_higher_priority_rule) {
    const auto pair = [](Combine rule) {
        return friction_of_pair({.friction = 0.2, .friction_rule = rule}, {.friction = 0.8});
    };
    EXPECT_NEAR(pair(Combine::average), 0.4, 0.01) << "the floor's geometric mean is stronger";
    EXPECT_NEAR(pair(Combine::geometric_mean), 0.4, 0.01);
    EXPECT_NEAR(pair(Combine::minimum), 0.2, 0.01);
    EXPECT_NEAR(pair(Combine::multiply), 0.16, 0.01);
    EXPECT_NEAR(pair(Combine::maximum), 0.8, 0.02);
    EXPECT_NEAR(friction_of_pair({.friction = 0.2, .friction_rule = Combine::average},
                                 {.friction = 0.8, .friction_rule = Combine::average}),
                0.5, 0.01);
}

TEST(Materials, restitution_uses_the_higher_priority_rule) {
    const auto rise = [](Combine rule) {
        World world = make_world();
        add_with(world, {.geometry = Plane{}, .type = BodyType::static_body},
                 {.restitution = 0.4, .restitution_rule = rule});
        const BodyId ball = add_with(world, {.geometry = Sphere{0.1}, .position = {0, 1.1, 0}},
                                     {.restitution = 0.9, .restitution_rule = rule});
        double highest = 0;
        for (int i = 0; i < 120; i++) {
            must(world.step(1.0 / 60));
            if (velocity_of(world, ball).y > 0)
                highest = std::max(highest, position_of(world, ball).y - 0.1);
        }
        return std::sqrt(highest);  // e = sqrt(h / 1 m)
    };
    EXPECT_NEAR(rise(Combine::maximum), 0.9, 0.02);
    EXPECT_NEAR(rise(Combine::minimum), 0.4, 0.02);
    EXPECT_NEAR(rise(Combine::average), 0.65, 0.02);
    EXPECT_NEAR(rise(Combine::multiply), 0.36, 0.02);
}

// A rolling ball with rolling friction c loses speed at c g / R * 5/7 and stops.
TEST(Materials, rolling_friction_stops_a_ball_at_the_analytic_distance) {
    const double c = 0.01, r = 0.25, v = 2;
    World world = make_world();
    add_floor(world, 1);
    const BodyId ball = add_with(world,
                                 {.geometry = Sphere{r},
                                  .position = {0, r, 0},
                                  .velocity = {v, 0, 0},
                                  .spin = {0, 0, -v / r}},
                                 {.friction = 1, .rolling_friction = c});
    run(world, 12);
    const double a = c * 9.81 / r / 1.4;
    EXPECT_NEAR(position_of(world, ball).x, v * v / (2 * a), 0.02 * v * v / (2 * a));
    EXPECT_FALSE(state_of(world, ball).awake) << "what has stopped sleeps";
}

// A ball that spins on the spot: the torque c m g takes its spin I w in t = I w / (c m g).
TEST(Materials, torsional_friction_stops_a_spinning_ball_at_the_analytic_time) {
    const double c = 0.02, r = 0.25, w = 10, inertia_per_mass = 0.4 * r * r;
    World world = make_world();
    add_floor(world, 1);
    const BodyId ball =
        add_with(world, {.geometry = Sphere{r}, .position = {0, r, 0}, .spin = {0, w, 0}},
                 {.friction = 1, .torsional_friction = c});
    const double stop = inertia_per_mass * w / (c * 9.81);
    run(world, 0.5 * stop);
    EXPECT_NEAR(state_of(world, ball).angular_velocity.y, 0.5 * w, 0.05 * w);
    run(world, 0.6 * stop);
    EXPECT_NEAR(state_of(world, ball).angular_velocity.y, 0, 0.01);
}

// Without it the disc in which a ball touches holds mu times a twenty-fifth of the radius per unit
// of force.
TEST(Materials, contact_patch_stops_a_spinning_ball_at_the_analytic_time) {
    const double mu = 0.5, r = 0.3, w = 1, inertia_per_mass = 0.4 * r * r;
    World world = make_world();
    add_floor(world, mu);
    const BodyId ball = add_with(
        world, {.geometry = Sphere{r}, .position = {0, r, 0}, .spin = {0, w, 0}}, {.friction = mu});
    const double stop = inertia_per_mass * w / (mu * 0.04 * r * 9.81);  // 0.6 s
    run(world, 0.5 * stop);
    EXPECT_NEAR(state_of(world, ball).angular_velocity.y, 0.5 * w, 0.05 * w);
    run(world, 0.5 * stop + 0.8);
    EXPECT_FALSE(state_of(world, ball).awake);
}

// A belt takes a box along: it slides at mu g until it has the belt's speed, then rides.
TEST(Materials, conveyor_accelerates_a_box_to_its_speed) {
    World world = make_world();
    add_with(
        world,
        {.geometry = Box{{20, 0.5, 1}}, .position = {0, -0.5, 0}, .type = BodyType::static_body},
        {.friction = 0.5, .surface_velocity = {2, 0, 0.5}});
    const BodyId box = add_with(world, {.geometry = Box{{0.3, 0.2, 0.3}}, .position = {0, 0.2, 0}},
                                {.friction = 0.5});
    run(world, 0.2);
    EXPECT_NEAR(length(velocity_of(world, box)), 0.5 * 9.81 * 0.2, 0.1);
    run(world, 2);
    EXPECT_TRUE(near(velocity_of(world, box), {2, 0, 0.5}, 0.01));
}

TEST(Materials, rotated_conveyor_drives_along_its_own_axis) {
    World world = make_world();
    add_with(world,
             {.geometry = Box{{20, 0.5, 20}},
              .position = {0, -0.5, 0},
              .rotation = from_rotation_vector({0, pi / 2, 0}),
              .type = BodyType::static_body},
             {.friction = 0.8, .surface_velocity = {2, 0, 0}});
    const BodyId box = add_with(world, {.geometry = Box{{0.3, 0.2, 0.3}}, .position = {0, 0.2, 0}},
                                {.friction = 0.8});
    run(world, 2);
    EXPECT_TRUE(near(velocity_of(world, box), {0, 0, -2}, 0.01));
}

TEST(Filters, categories_masks_and_groups_control_collision) {
    struct Case {
        Filter a, b;
        bool meets;
    };
    const Case cases[] = {
        {{}, {}, true},
        {{.category = 2}, {.mask = 1}, false},
        {{.category = 2, .mask = 0}, {}, false},
        {{.category = 2}, {.category = 4, .mask = 6}, true},
        {{.group = -3}, {.group = -3}, false},
        {{.group = -3}, {.group = -4}, true},
        {{.category = 2, .mask = 0, .group = 5}, {.category = 2, .mask = 0, .group = 5}, true},
    };
    for (const Case& c : cases) {
        World world = make_world();
        add_with(
            world,
            {.geometry = Box{{5, 0.5, 5}}, .position = {0, -0.5, 0}, .type = BodyType::static_body},
            {}, c.a);
        const BodyId ball =
            add_with(world, {.geometry = Sphere{0.3}, .position = {0, 1, 0}}, {}, c.b);
        run(world, 2);
        EXPECT_EQ(position_of(world, ball).y > 0, c.meets)
            << "categories " << c.a.category << ", " << c.b.category << " groups " << c.a.group
            << ", " << c.b.group;
    }
}

TEST(Filters, change_takes_effect_with_the_next_step) {
    World world = make_world();
    add_floor(world);
    const BodyId box = add(world, {.position = {0, 0.5, 0}});
    run(world, 2);
    EXPECT_FALSE(state_of(world, box).awake);
    must(world.set_filter(world.shapes_of(box)[0], {.mask = 0}));
    run(world, 1);
    EXPECT_LT(position_of(world, box).y, -3);
}

// A body that may only move along x and turn about z, pushed by a ball from an odd side.
TEST(Locks, locked_axes_do_not_move_and_free_axes_conserve_momentum) {
    World world = make_world({.gravity = {}});
    const BodyId slider =
        must(world.create_body({.locks = lock_y | lock_z | lock_rotation_x | lock_rotation_y},
                               {.geometry = Box{{0.5, 0.3, 0.4}}, .material = {.friction = 0.5}}));
    const BodyId ball = add(world, {.geometry = Sphere{0.2},
                                    .position = {-2, 0.25, 0.2},
                                    .velocity = {6, 0.3, 0.1},
                                    .density = 3000});
    run(world, 1.5);
    const BodyState s = state_of(world, slider);
    EXPECT_EQ(s.pose.position.y, 0);
    EXPECT_EQ(s.pose.position.z, 0);
    EXPECT_EQ(s.linear_velocity.y, 0);
    EXPECT_EQ(s.angular_velocity.x, 0);
    EXPECT_EQ(s.angular_velocity.y, 0);
    EXPECT_GT(s.linear_velocity.x, 0.5);
    EXPECT_NE(s.angular_velocity.z, 0) << "the ball hit it above its centre";
    const double before = 6 * state_of(world, ball).mass;
    const double after =
        s.mass * s.linear_velocity.x + state_of(world, ball).mass * velocity_of(world, ball).x;
    EXPECT_NEAR(after, before, 1e-3 * before);
}

// A box with all turns locked slides down a slope without tipping; a tall one would tip.
TEST(Locks, locked_rotations_keep_a_tall_box_upright) {
    World world = make_world({.gravity = leaning_gravity(0.8, 0.3)});
    add_floor(world, 0.3);
    const BodyId tower = must(world.create_body(
        {.pose = {{0, 1, 0}, {}}, .locks = lock_rotation_x | lock_rotation_y | lock_rotation_z},
        {.geometry = Box{{0.1, 1, 0.1}}, .material = {.friction = 0.3}}));
    run(world, 2);
    EXPECT_EQ(state_of(world, tower).pose.rotation, Quat{});
    EXPECT_GT(position_of(world, tower).x, 1);
    EXPECT_NEAR(position_of(world, tower).y, 1, 2e-3);
}

TEST(Locks, stack_with_locked_rotations_stands_on_one_point_each) {
    World world = make_world({.sleeping = false});
    add_floor(world);
    std::vector<BodyId> boxes;
    for (int k = 0; k < 10; k++)
        boxes.push_back(
            must(world.create_body({.pose = {{0.3 * (k % 2), 0.5 + k, 0}, {}},
                                    .locks = lock_rotation_x | lock_rotation_y | lock_rotation_z},
                                   {.geometry = Box{}})));
    run(world, 5);
    for (int k = 0; k < 10; k++)
        EXPECT_TRUE(near(position_of(world, boxes[static_cast<std::size_t>(k)]),
                         {0.3 * (k % 2), 0.5 + k, 0}, 5e-3))
            << k;
    const std::vector<ContactInfo> contacts = world.contacts();
    EXPECT_EQ(contacts.size(), 10u);
    for (const ContactInfo& contact : contacts) EXPECT_EQ(contact.count, 1);
}

TEST(Bodies, gravity_scale_and_damping_are_per_body) {
    World world = make_world();
    const BodyId light =
        must(world.create_body({.gravity_scale = 0.25}, {.geometry = Sphere{0.1}}));
    const BodyId rising = must(world.create_body({.gravity_scale = -1}, {.geometry = Sphere{0.1}}));
    const BodyId slow = must(
        world.create_body({.linear_velocity = {4, 0, 0}, .linear_damping = 0.5, .gravity_scale = 0},
                          {.geometry = Sphere{0.1}}));
    must(world.set_pose(rising, {{5, 0, 0}, {}}));
    must(world.set_pose(slow, {{0, 0, 5}, {}}));
    run(world, 1);
    EXPECT_NEAR(position_of(world, light).y, -0.25 * 9.81 / 2, 1e-6);
    EXPECT_NEAR(position_of(world, rising).y, 9.81 / 2, 1e-6);
    EXPECT_NEAR(velocity_of(world, slow).x, 4 * std::exp(-0.5), 1e-3);
}

TEST(Bodies, mass_can_replace_density) {
    World world = make_world();
    const BodyId by_shape =
        must(world.create_body({}, {.geometry = Box{{0.5, 1, 1.5}}, .mass = 30}));
    const BodyId by_body =
        must(world.create_body({.mass = 30}, {.geometry = Box{{0.5, 1, 1.5}}, .density = 7}));
    for (const BodyId body : {by_shape, by_body}) {
        const BodyState s = state_of(world, body);
        EXPECT_NEAR(s.mass, 30, 1e-12);
        EXPECT_NEAR(s.inertia.x.x, 30.0 / 3 * (1 + 2.25), 1e-9);
        EXPECT_NEAR(s.inertia.z.z, 30.0 / 3 * (0.25 + 1), 1e-9);
    }
}

// A lift: the box on it rises with it, at its speed, and stays on it.
TEST(Kinematic, move_to_carries_bodies_on_the_platform) {
    World world = make_world();
    const BodyId lift = add(world, {.geometry = Box{{2, 0.1, 2}}, .type = BodyType::kinematic});
    const BodyId box = add(world, {.geometry = Box{{0.3, 0.3, 0.3}}, .position = {0.5, 0.4, 0}});
    run(world, 0.5);
    const double dt = 1.0 / 60;
    for (int i = 1; i <= 120; i++) {
        // Up by a metre and half a turn round, smoothly.
        const double s = i / 120.0, smooth = s * s * (3 - 2 * s);
        must(world.move_to(lift, {{0, smooth, 0}, from_rotation_vector({0, pi * smooth, 0})}, dt));
        must(world.step(dt));
    }
    EXPECT_NEAR(position_of(world, lift).y, 1, 1e-9);
    EXPECT_NEAR(position_of(world, box).y, 1.4, 5e-3);
    EXPECT_NEAR(position_of(world, box).x, -0.5, 0.05) << "half a turn round";
}

}  // namespace
}  // namespace jostle::test
