// SPDX-License-Identifier: MIT
//
// Flocks: order, cohesion and separation.
#include <gtest/gtest.h>

#include "tests/modules/crowd/people.h"
#include "tests/support/random.h"

namespace jostle::modules {
namespace {

using physics::Vec3;

struct FlockFigures {
    double order = 0;        // length of the mean heading: 1 if all fly in one direction
    double extent = 0;       // m, root mean square distance from the centre
    double local_order = 0;  // mean cosine between the headings of nearest neighbours
    double nearest = 0;      // m, smallest distance of two flyers
    double speed = 0;        // m/s, mean
};

FlockFigures figures_of(physics::World& world) {
    FlockFigures figures{.nearest = 1e9};
    const auto ids = crowd_of(world).ids();
    const double n = static_cast<double>(ids.size());
    Vec3 heading, center;
    std::vector<Vec3> points, headings;
    for (const AgentId id : ids) {
        const AgentState state = test::must(crowd_of(world).state(world, id));
        heading += normalized(state.velocity) * (1 / n);
        figures.speed += length(state.velocity) / n;
        center += state.position * (1 / n);
        points.push_back(state.position);
        headings.push_back(normalized(state.velocity));
    }
    figures.order = length(heading);
    for (const Vec3 p : points) figures.extent += length_squared(p - center) / n;
    figures.extent = physics::square_root(figures.extent);
    for (std::size_t a = 0; a < points.size(); a++) {
        double distance = 1e9;
        std::size_t nearest = a;
        for (std::size_t b = 0; b < points.size(); b++)
            if (const double between = length(points[a] - points[b]); a != b && between < distance)
                distance = between, nearest = b;
        figures.nearest = std::min(figures.nearest, distance);
        figures.local_order += dot(headings[a], headings[nearest]) / n;
    }
    return figures;
}

// n flyers with random positions and headings. They set out slowly, and so align before they
// disperse.
void add_flyers(physics::World& world, int n, double spread, bool planar = false) {
    test::Random random(4);
    for (int k = 0; k < n; k++) {
        Vec3 p = random.vector(spread), v = random.direction();
        if (planar) p.z = v.z = 0;
        const auto body = test::must(world.create_body(
            {.type = physics::BodyType::kinematic, .pose = {p, {}}, .linear_velocity = v},
            {.geometry = physics::Sphere{0.1}}));
        test::must(crowd_of(world).add(world, {.body = body,
                                               .kind = AgentKind::flyer,
                                               .radius = 0.1,
                                               .speed = 4,
                                               .max_speed = 6,
                                               .acceleration = 15}));
    }
}

TEST(Flock, headings_align_and_the_flock_stays_together) {
    physics::World world;
    Crowd& crowd = add_crowd(world);
    test::must(crowd.add_flock({}));
    add_flyers(world, 150, 3);
    const FlockFigures before = figures_of(world);
    test::run(world, 20);
    const FlockFigures after = figures_of(world);
    EXPECT_LT(before.order, 0.2);
    EXPECT_GT(after.order, 0.95);
    EXPECT_LT(after.extent, 10);
    EXPECT_GE(after.nearest, 2 * 0.1 * 0.995);
    EXPECT_NEAR(after.speed, 4, 0.5);
    RecordProperty("order", std::to_string(after.order));
    RecordProperty("extent_m", std::to_string(after.extent));
    RecordProperty("nearest_m", std::to_string(after.nearest));
}

TEST(Flock, without_alignment_headings_stay_disordered) {
    physics::World world;
    Crowd& crowd = add_crowd(world);
    test::must(crowd.add_flock({.alignment_weight = 0}));
    add_flyers(world, 150, 3);
    test::run(world, 10);
    EXPECT_LT(figures_of(world).order, 0.6);
}

TEST(Flock, flyers_turn_back_at_the_limit_of_their_home) {
    physics::World world;
    Crowd& crowd = add_crowd(world);
    test::must(crowd.add_flock({.roam = 12, .home = {0, 10, 0}}));
    add_flyers(world, 60, 3);
    for (int k = 0; k < 60; k++) {
        test::run(world, 1);
        for (const Vec3 p : positions_of(world)) ASSERT_LT(length(p - Vec3{0, 10, 0}), 30);
    }
}

TEST(Flock, planar_world_keeps_its_flock_in_the_plane) {
    physics::World world = test::make_world({.gravity = {}, .planar = true});
    Crowd& crowd = add_crowd(world, {.vertical = true});
    test::must(crowd.add_flock({}));
    add_flyers(world, 80, 5, true);
    test::run(world, 15);
    EXPECT_GT(figures_of(world).local_order, 0.95);  // it may split into several flocks
    for (const Vec3 p : positions_of(world)) EXPECT_EQ(p.z, 0);
}

}  // namespace
}  // namespace jostle::modules
