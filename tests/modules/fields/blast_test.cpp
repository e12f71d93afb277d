// SPDX-License-Identifier: MIT
//
// Explosions push visible surfaces in proportion to their area, and nothing behind walls.
#include "jostle/modules/blast.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

#include "jostle/modules/deformables.h"
#include "tests/modules/fields/with_fields.h"
#include "tests/support/near.h"
#include "tests/support/random.h"

namespace jostle::modules {
namespace {

// A plate of 1 m^2 that faces the origin.
BodyId add_plate(World& world, double distance) {
    return test::add(world, {.geometry = Box{{0.02, 0.5, 0.5}}, .position = {distance, 0, 0}});
}
BlastImpulse push_on(const World& world, const Explosion& explosion, BodyId body) {
    for (const BlastImpulse& push : test::must(compute_blast(world, explosion)))
        if (push.body == body) return push;
    return {};
}
Explosion even(double strength) {
    return {.radius = 100, .strength = strength, .falloff = 0, .fade = false};
}

TEST(Blast, far_plate_receives_pressure_times_area) {
    World world = test::make_world({.gravity = {}});
    const BodyId plate = add_plate(world, 10.02);
    const BlastImpulse push = push_on(world, even(300), plate);
    RecordProperty("plate_error", std::to_string(push.impulse.x / 300 - 1));
    EXPECT_NEAR(push.impulse.x / 300, 1, 5e-3);
    EXPECT_NEAR(push.area, 1, 5e-3);
    EXPECT_NEAR(push.impulse.y, 0, 0.1);
    EXPECT_NEAR(push.impulse.z, 0, 0.1);
    EXPECT_LT(length(push.angular_impulse), 0.1);
    EXPECT_EQ(push.occluded_area, 0);
}

// A disc of radius R at distance d: strength core^2 int cos^2 / r^2 dA
//     = strength core^2 pi R^2 / (d^2 + R^2).
TEST(Blast, near_disc_matches_the_closed_form) {
    World world = test::make_world({.gravity = {}});
    const BodyId disc = test::add(world, {.geometry = Cylinder{1, 0.02},
                                          .position = {1.02, 0, 0},
                                          .rotation = from_axis_angle({0, 0, 1}, pi / 2)});
    Explosion explosion{.radius = 100, .strength = 300, .core = 0.5, .fade = false, .points = 512};
    const double expected = 300 * 0.25 * pi / 2;
    const double found = push_on(world, explosion, disc).impulse.x;
    explosion.points = 64;
    const double coarse = push_on(world, explosion, disc).impulse.x;
    RecordProperty("disc_error", std::to_string(found / expected - 1));
    RecordProperty("disc_error_64_points", std::to_string(coarse / expected - 1));
    EXPECT_NEAR(found / expected, 1, 0.01);
    EXPECT_NEAR(coarse / expected, 1, 0.03);
}

TEST(Blast, wall_blocks_the_blast_and_its_edge_blocks_half) {
    World world = test::make_world({.gravity = {}});
    const BodyId hidden = add_plate(world, 6), half = add_plate(world, -6);
    test::add_static(world, {.geometry = Box{{0.1, 3, 3}}, .position = {3, 0, 0}});
    test::add_static(world, {.geometry = Box{{0.1, 3, 3}}, .position = {-3, 3, 0}});
    const BlastImpulse behind = push_on(world, even(300), hidden);
    EXPECT_EQ(behind.impulse, Vec3{});
    EXPECT_EQ(behind.angular_impulse, Vec3{});
    EXPECT_NEAR(behind.occluded_area, 1, 0.01);
    Explosion fine = even(300);
    fine.points = 256;
    const BlastImpulse past = push_on(world, fine, half);
    RecordProperty("half_hidden", std::to_string(past.impulse.x / -300));
    EXPECT_NEAR(past.impulse.x / -300, 0.5, 0.03);
    // Only the lower half is pushed: a force below the centre along -x rotates it about z,
    // backwards.
    EXPECT_NEAR(past.angular_impulse.z / -(300 * 0.5 * 0.25), 1, 0.06);
    // A dynamic body shields as well.
    World other = test::make_world({.gravity = {}});
    const BodyId shield = add_plate(other, 3), sheltered = add_plate(other, 3.2);
    EXPECT_GT(push_on(other, even(300), shield).impulse.x, 290);
    EXPECT_EQ(push_on(other, even(300), sheltered).impulse, Vec3{});
}

TEST(Blast, applied_momentum_matches_the_reported_impulse) {
    World world = test::make_world({.gravity = {}});
    test::Random random(2);
    const Geometry kinds[] = {Box{{0.3, 0.5, 0.4}}, Sphere{0.4}, Capsule{0.2, 0.4},
                              Cylinder{0.3, 0.4}, Cone{0.4, 0.5}};
    for (int k = 0; k < 40; k++)
        test::add(world, {.geometry = kinds[k % 5],
                          .position = random.direction() * random.in(1.5, 8),
                          .rotation = random.rotation()});
    const WorldSummary before = world.summary();
    const auto pushes = test::must(explode(world, {.strength = 500}));
    Vec3 linear, angular;
    double sum = 0;
    for (const BlastImpulse& push : pushes) {
        linear += push.impulse;
        angular += push.angular_impulse + cross(push.center, push.impulse);
        sum += length(push.impulse);
        const BodyState body = test::state_of(world, push.body);
        EXPECT_TRUE(test::near(body.linear_velocity * body.mass, push.impulse, 1e-9 * sum));
    }
    const WorldSummary after = world.summary();
    EXPECT_GT(pushes.size(), 20u);
    EXPECT_TRUE(test::near(after.linear_momentum - before.linear_momentum, linear, 1e-9 * sum));
    EXPECT_TRUE(test::near(after.angular_momentum - before.angular_momentum, angular, 1e-9 * sum));
    // Each point is pushed away from the centre, so there is no torque about it.
    EXPECT_LT(length(angular), 1e-9 * sum);
}

// Six walls around an off-centre explosion with falloff 2: each receives an impulse according to
// its solid angle.
TEST(Blast, enclosing_shell_receives_zero_net_impulse) {
    World world = test::make_world({.gravity = {}});
    for (int k = 0; k < 6; k++) {
        Vec3 half{2, 2, 2}, at;
        half[k / 2] = 0.05;
        at[k / 2] = k % 2 == 0 ? 2.05 : -2.05;
        test::add(world, {.geometry = Box{half}, .position = at});
    }
    const auto pushes = test::must(compute_blast(
        world,
        {.center = {0.7, -0.4, 0.2}, .radius = 100, .core = 0.1, .fade = false, .points = 512}));
    Vec3 total;
    double sum = 0, solid_angle = 0;
    for (const BlastImpulse& push : pushes) total += push.impulse, sum += length(push.impulse);
    for (const BlastImpulse& push : pushes) solid_angle += push.area;
    RecordProperty("momentum_left", std::to_string(length(total) / sum));
    EXPECT_EQ(pushes.size(), 6u);
    EXPECT_LT(length(total) / sum, 0.01);
    EXPECT_GT(solid_angle, 0);
}

TEST(Blast, standoff_blast_wakes_and_lifts_a_crate_on_the_floor) {
    World world = test::make_world();
    test::add_floor(world);
    const BodyId crate = test::add(world, {.position = {1.2, 0.5, 0}, .density = 100});
    const BodyId struck = test::add(world, {.position = {-3, 0.5, 0}, .density = 100});
    test::run(world, 2);
    ASSERT_FALSE(test::state_of(world, crate).awake);
    // At the floor, slightly below its surface because of rounding.
    test::must(explode(world, {.center = {0, -1e-6, 0}, .strength = 800}));
    EXPECT_TRUE(test::state_of(world, crate).awake);
    EXPECT_GT(test::velocity_of(world, crate).x, 2);
    // On the face of a crate: visibility requires some distance.
    const Explosion on_face{.center = {-2.5, 0.5, 0}, .strength = 800};
    EXPECT_LT(length(push_on(world, on_face, struck).impulse), 1);
    Explosion with_standoff = on_face;
    with_standoff.standoff = 0.3;
    EXPECT_LT(push_on(world, with_standoff, struck).impulse.x, -100);
}

TEST(Blast, compound_children_occlude_each_other) {
    World world = test::make_world({.gravity = {}});
    const auto two = test::must(build_compound({{Box{{0.02, 0.5, 0.5}}, {{0, 0, 0}, {}}},
                                                {Box{{0.02, 0.5, 0.5}}, {{1, 0, 0}, {}}},
                                                {Sphere{0.5}, {{3, 0, 0}, {}}}}));
    const BodyId body = test::add(world, {.geometry = Compound{two}, .position = {8, 0, 0}});
    const BlastImpulse push = push_on(world, even(300), body);
    EXPECT_NEAR(push.area, 1, 0.02);
    EXPECT_NEAR(push.occluded_area, 1 + pi / 4, 0.06);
}

TEST(Blast, respects_mask_radius_and_speed_limit) {
    World world = test::make_world({.gravity = {}});
    const BodyId plate = add_plate(world, 5);
    Explosion explosion = even(1e6);
    explosion.max_speed = 20;
    EXPECT_NEAR(length(push_on(world, explosion, plate).impulse),
                20 * test::state_of(world, plate).mass, 1e-6);
    explosion.max_speed = 0;
    explosion.strength = 1e9;
    test::must(explode(world, explosion));
    EXPECT_LE(length(test::velocity_of(world, plate)), 1e4 * (1 + 1e-12))
        << "the limit of World::apply_impulse()";
    explosion.mask = 2;
    EXPECT_TRUE(test::must(compute_blast(world, explosion)).empty());
    explosion.mask = 1;
    explosion.radius = 4;
    EXPECT_TRUE(test::must(compute_blast(world, explosion)).empty());
    EXPECT_EQ(compute_blast(world, {.points = 2}).error().message,
              "explosion.points is 2; it must be from 6 to 1024");
}

TEST(Blast, charge_explodes_at_its_time) {
    World world = test::make_world({.gravity = {}});
    const BodyId plate = add_plate(world, 3);
    Fields& fields = fields_of(world);
    test::must(fields.add_charge({.time = 0.5, .explosion = {.strength = 300}}));
    test::run(world, 0.5);
    EXPECT_EQ(test::velocity_of(world, plate), Vec3{});
    EXPECT_EQ(fields.charges().size(), 1u);
    test::run(world, 0.05);
    EXPECT_GT(test::velocity_of(world, plate).x, 0);
    EXPECT_TRUE(fields.charges().empty());
    // The explosions of a salvo are distributed over several steps.
    for (int k = 0; k < 12; k++) test::must(fields.add_charge({.explosion = {.strength = 1}}));
    test::must(world.step(1.0 / 60));
    EXPECT_EQ(fields.blasts().size(), Fields::blasts_max);
    test::must(world.step(1.0 / 60));
    EXPECT_EQ(fields.blasts().size(), 12 - Fields::blasts_max);
}

// Records the pulse at two points.
class Probe : public Module, public PulseReceiver {
public:
    explicit Probe(std::vector<Vec3> points) : points_(std::move(points)) {}
    std::string_view tag() const override { return "probe"; }
    void visit(StateVisitor&) override {}
    void apply_pulse(World&, const PressurePulse& pulse) override {
        for (const Vec3 point : points_) pressures.push_back(pulse.impulse_per_area(point));
        max_speed = pulse.max_speed;
    }

    std::vector<Vec3> pressures;
    double max_speed = 0;

private:
    std::vector<Vec3> points_;
};

TEST(Blast, pushes_the_matter_of_modules_that_it_sees) {
    World world = test::make_world({.gravity = {}});
    test::add_static(world, {.geometry = Box{{0.1, 2, 2}}, .position = {3, 0, 0}});
    auto owned = std::make_unique<Probe>(std::vector<Vec3>{{-4, 0, 0}, {4, 0, 0}, {0, 20, 0}});
    const Probe& probe = *owned;
    test::must(world.add_module(std::move(owned)));
    test::must(push_deformables(
        world, {.radius = 10, .strength = 100, .core = 2, .falloff = 1, .max_speed = 7}));
    ASSERT_EQ(probe.pressures.size(), 3u);
    EXPECT_NEAR(probe.pressures[0].x, -100 * (2.0 / 4) * (1 - 4.0 / 10), 1e-9);
    EXPECT_EQ(probe.pressures[1], Vec3{}) << "behind the wall";
    EXPECT_EQ(probe.pressures[2], Vec3{}) << "beyond the radius";
    EXPECT_EQ(probe.max_speed, 7);
    EXPECT_FALSE(push_deformables(world, {.radius = -1}).ok());
}

}  // namespace
}  // namespace jostle::modules
