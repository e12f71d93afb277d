// SPDX-License-Identifier: MIT
//
// Mass, centre and inertia against a sum over small cells of every shape, compounds included.
#include <gtest/gtest.h>

#include "tests/support/distance_field.h"
#include "tests/support/near.h"
#include "tests/support/random.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

struct Sum {
    double mass = 0;
    Vec3 first;                         // sum of m p
    Mat3 second = diagonal({0, 0, 0});  // sum of m p p^T
};

double reach_of(const Geometry& g) {
    if (const auto* c = std::get_if<Capsule>(&g)) return c->radius + c->half_length;
    if (const auto* s = std::get_if<Sphere>(&g)) return s->radius;
    if (const auto* c = std::get_if<Cylinder>(&g)) return std::max(c->radius, c->half_length);
    if (const auto* c = std::get_if<Cone>(&g)) return std::max(c->radius, c->half_length);
    if (const auto* h = std::get_if<Hull>(&g))
        return length(max(abs(h->data->bounds.low), abs(h->data->bounds.high)));
    return length(std::get<Box>(g).half_extents);
}

// Cells of 1/80 of the shape's size; a cell counts by the share of it below the surface.
void add_cells(Sum& sum, const ShapeDef& shape, const Transform& body) {
    const double size = reach_of(shape.geometry);
    const double cell = size / 40;
    for (int i = -41; i <= 41; i++)
        for (int j = -41; j <= 41; j++)
            for (int k = -41; k <= 41; k++) {
                const Vec3 p = Vec3{i + 0.5, j + 0.5, k + 0.5} * cell;
                const double d = signed_distance(shape.geometry, p);
                const double share = std::clamp(0.5 - d / cell, 0.0, 1.0);
                if (share == 0) continue;
                const double m = share * shape.density * cell * cell * cell;
                const Vec3 x = apply(body, apply(shape.pose, p));
                sum.mass += m;
                sum.first += x * m;
                sum.second = sum.second + Mat3{x * (m * x.x), x * (m * x.y), x * (m * x.z)};
            }
}

void expect_inertia(const Mat3& value, const Mat3& expected, double tolerance) {
    const double scale = expected.x.x + expected.y.y + expected.z.z;
    for (int c = 0; c < 3; c++) {
        const Vec3 a = c == 0 ? value.x : c == 1 ? value.y : value.z;
        const Vec3 b = c == 0 ? expected.x : c == 1 ? expected.y : expected.z;
        EXPECT_TRUE(near(a, b, tolerance * scale)) << "column " << c;
    }
}

TEST(Mass, random_compounds_match_a_sum_over_cells) {
    Random random(5);
    for (int round = 0; round < 8; round++) {
        World world = make_world();
        const Transform pose{random.vector(3), random.rotation()};
        const BodyId body = must(world.create_body({.pose = pose}));
        Sum sum;
        const int shapes = 1 + round % 3;
        for (int i = 0; i < shapes; i++) {
            std::vector<Vec3> points;
            for (int k = 0; k < 12; k++) points.push_back(random.vector(0.9));
            const Geometry kinds[] = {
                Sphere{random.in(0.2, 1)},
                Capsule{random.in(0.2, 0.6), random.in(0.2, 0.8)},
                Box{{random.in(0.3, 1), random.in(0.3, 1), random.in(0.3, 1)}},
                Cylinder{random.in(0.3, 0.8), random.in(0.3, 0.8)},
                Cone{random.in(0.4, 0.9), random.in(0.4, 0.9)},
                Hull{must(build_hull(points))}};
            const ShapeDef shape{.geometry = kinds[(round + 2 * i) % 6],
                                 .pose = {random.vector(1), random.rotation()},
                                 .density = random.in(200, 3000)};
            must(world.create_shape(body, shape));
            add_cells(sum, shape, pose);
        }
        const Vec3 center = sum.first / sum.mass;
        const Mat3 about =
            sum.second - Mat3{center * (sum.mass * center.x), center * (sum.mass * center.y),
                              center * (sum.mass * center.z)};
        const double trace = about.x.x + about.y.y + about.z.z;
        const BodyState s = state_of(world, body);
        EXPECT_NEAR(s.mass, sum.mass, 0.01 * sum.mass);
        EXPECT_TRUE(near(s.center, center, 0.01));
        expect_inertia(s.inertia, diagonal({trace, trace, trace}) - about, 0.01);
    }
}

TEST(Mass, matches_closed_forms) {
    const auto state = [](const Geometry& geometry) {
        World world = make_world();
        return state_of(world, add(world, {.geometry = geometry, .density = 3}));
    };
    const BodyState ball = state(Sphere{2});
    EXPECT_NEAR(ball.mass, 3 * 4.0 / 3 * pi * 8, 1e-9);
    EXPECT_NEAR(ball.inertia.x.x, 0.4 * ball.mass * 4, 1e-9);
    const BodyState box = state(Box{{1, 2, 3}});
    EXPECT_NEAR(box.mass, 3 * 8 * 6, 1e-9);
    EXPECT_NEAR(box.inertia.x.x, box.mass / 3 * (4 + 9), 1e-9);
    EXPECT_NEAR(box.inertia.y.y, box.mass / 3 * (1 + 9), 1e-9);
    EXPECT_NEAR(box.inertia.z.z, box.mass / 3 * (1 + 4), 1e-9);
    const BodyState capsule = state(Capsule{0.5, 1});
    const double cylinder = 3 * pi * 0.25 * 2, ends = 3 * 4.0 / 3 * pi * 0.125;
    EXPECT_NEAR(capsule.mass, cylinder + ends, 1e-9);
    EXPECT_NEAR(capsule.inertia.y.y, 0.5 * cylinder * 0.25 + 0.4 * ends * 0.25, 1e-9);
    EXPECT_NEAR(capsule.inertia.x.x,
                cylinder * (0.25 / 4 + 4.0 / 12) + ends * (0.4 * 0.25 + 1 + 2 * 1 * 3.0 / 8 * 0.5),
                1e-9);
}

// What floats cannot hold the inverse of is refused, wherever a mass is given.
TEST(Mass, is_zero_or_finite_and_positive) {
    World world = make_world();
    const BodyId body = add(world, {});
    for (const double mass : {1e-310, 1e-10, -1.0, 1e16}) {
        EXPECT_FALSE(world.set_mass(body, mass).ok()) << mass;
        EXPECT_FALSE(world.create_body({.mass = mass}, {.geometry = Sphere{}}).ok()) << mass;
        EXPECT_FALSE(world.create_body({}, {.geometry = Sphere{}, .mass = mass}).ok()) << mass;
    }
    must(world.set_mass(body, 1e-9));
    EXPECT_EQ(state_of(world, body).mass, 1e-9);
}

TEST(Mass, explicit_mass_needs_no_density) {
    World world = make_world();
    const BodyId body =
        must(world.create_body({}, {.geometry = Sphere{0.5}, .density = 0, .mass = 3}));
    EXPECT_DOUBLE_EQ(state_of(world, body).mass, 3);
    EXPECT_NEAR(state_of(world, body).inertia.x.x, 0.4 * 3 * 0.25, 1e-12);
}

TEST(Mass, removing_a_shape_restores_the_mass) {
    World world = make_world();
    const BodyId body = add(world, {.geometry = Box{{1, 2, 3}}});
    const BodyState before = state_of(world, body);
    const ShapeId extra =
        must(world.create_shape(body, {.geometry = Sphere{1}, .pose = {{5, 0, 0}, {}}}));
    EXPECT_GT(state_of(world, body).center.x, 0.1);
    must(world.destroy_shape(extra));
    const BodyState after = state_of(world, body);
    EXPECT_EQ(after.mass, before.mass);
    EXPECT_TRUE(near(after.pose.position, before.pose.position, 1e-12));
    EXPECT_TRUE(near(after.center, before.center, 1e-12));
}

}  // namespace
}  // namespace jostle::test
