// SPDX-License-Identifier: MIT
//
// Contacts that stay are listed with their impulses, hard ones as hits, parted ones as ends: once
// for a pair, however many manifolds it has.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/near.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

TEST(ContactReports, resting_box_reports_its_weight) {
    World world = make_world();
    add_floor(world);
    const BodyId box = must(world.create_body({.pose = {{0, 0.5, 0}, {}}, .sleep_allowed = false},
                                              {.report_stays = true}));
    const BodyId other = add(world, {.position = {5, 0.5, 0}, .sleep_allowed = false});
    run(world, 1);
    const auto stays = world.events().contacts;
    ASSERT_EQ(stays.size(), 1u) << "only what asked is listed";
    EXPECT_TRUE(stays[0].body_a == box || stays[0].body_b == box);
    EXPECT_NE(stays[0].body_a, other);
    EXPECT_NEAR(stays[0].normal_impulse, 1000 * 9.81 / 60, 1000 * 9.81 / 60 * 0.001);
    EXPECT_NEAR(stays[0].friction_impulse, 0, 1);
    EXPECT_NEAR(std::fabs(stays[0].normal.y), 1, 1e-9);
}

TEST(ContactReports, friction_on_a_slope_is_the_tangential_weight) {
    const double slope = 0.3;
    World world = make_world({.gravity = leaning_gravity(slope, 0.5)});
    add_floor(world, 0.6);
    must(world.create_body({.pose = {{0, 0.5, 0}, {}}, .sleep_allowed = false},
                           {.material = {.friction = 0.6}, .report_stays = true}));
    run(world, 1);
    const double angle = std::atan(slope), weight = 1000 * 9.81 / 60;
    ASSERT_EQ(world.events().contacts.size(), 1u);
    EXPECT_NEAR(world.events().contacts[0].friction_impulse, weight * std::sin(angle),
                0.01 * weight);
    EXPECT_NEAR(world.events().contacts[0].normal_impulse, weight * std::cos(angle), 0.01 * weight);
}

// Dropped from 1 m and from 5 cm: only the first is harder than 2 m/s.
TEST(ContactReports, hits_are_reported_above_the_hit_speed) {
    for (const double height : {0.05, 1.0}) {
        World world = make_world({.hit_speed = 2});
        add_floor(world);
        const BodyId ball = add(world, {.geometry = Sphere{0.2}, .position = {0, 0.2 + height, 0}});
        std::vector<ContactHit> hits;
        int begins = 0;
        for (int i = 0; i < 60; i++) {
            must(world.step(1.0 / 60));
            for (const ContactHit& h : world.events().hits) hits.push_back(h);
            begins += static_cast<int>(world.events().contacts_began.size());
        }
        EXPECT_EQ(begins, 1);
        ASSERT_EQ(hits.size(), height > 0.5 ? 1u : 0u);
        if (hits.empty()) continue;
        EXPECT_NEAR(hits[0].approach_speed, std::sqrt(2 * 9.81 * height), 0.2);
        EXPECT_TRUE(hits[0].body_a == ball || hits[0].body_b == ball);
        EXPECT_TRUE(near(hits[0].point, {0, 0, 0}, 0.05));
    }
}

// A ball so fast that it is swept meets a wall between sub-steps: what it gave it is told, m v.
TEST(ContactReports, impact_between_substeps_reports_the_reversed_momentum) {
    for (const double restitution : {0.0, 0.5}) {
        World world = make_world({.gravity = {}});
        must(world.create_body({.type = BodyType::static_body},
                               {.geometry = Box{{0.1, 2, 2}},
                                .material = {.friction = 0, .restitution = restitution},
                                .report_stays = true}));
        const BodyId ball = add(world, {.geometry = Sphere{0.1},
                                        .position = {-3.05, 0, 0},
                                        .velocity = {100, 0, 0},
                                        .friction = 0,
                                        .restitution = restitution});
        const double mass = world.body(ball)->mass;
        double told = 0;
        for (int k = 0; k < 10; k++) {
            must(world.step(1.0 / 60));
            for (const ContactStay& stay : world.events().contacts) {
                told += stay.normal_impulse;
                EXPECT_EQ(stay.body_a, ball);
                EXPECT_NEAR(stay.normal.x, 1, 1e-9);
            }
        }
        EXPECT_NEAR(told, mass * (100 - velocity_of(world, ball).x), 1e-6 * mass * 100);
    }
}

// A box that slides over forty triangles begins to touch them once, and ends once.
TEST(ContactReports, mesh_reports_one_contact_for_any_number_of_triangles) {
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (std::uint32_t i = 0; i <= 20; i++) {
        vertices.push_back({i * 0.5 - 5, 0, -2});
        vertices.push_back({i * 0.5 - 5, 0, 2});
        if (i == 0) continue;
        const std::uint32_t v = 2 * (i - 1);
        triangles.push_back({v, v + 1, v + 2});
        triangles.push_back({v + 1, v + 3, v + 2});
    }
    World world = make_world();
    add(world, {.geometry = Mesh{must(build_mesh(vertices, triangles))},
                .friction = 0,
                .type = BodyType::static_body});
    add(world, {.geometry = Box{{0.4, 0.2, 0.4}},
                .position = {-4, 0.2, 0},
                .velocity = {6, 0, 0},
                .friction = 0});
    int began = 0, ended = 0;
    for (int i = 0; i < 150; i++) {
        must(world.step(1.0 / 60));
        began += static_cast<int>(world.events().contacts_began.size());
        ended += static_cast<int>(world.events().contacts_ended.size());
    }
    EXPECT_EQ(began, 1);
    EXPECT_EQ(ended, 1) << "it fell off the far end";
}

}  // namespace
}  // namespace jostle::test
