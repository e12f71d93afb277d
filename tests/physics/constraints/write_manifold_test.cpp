// SPDX-License-Identifier: MIT
//
// A manifold that is rebuilt from other points bears what it bore.
#include "physics/src/constraints/write_manifold.h"

#include <gtest/gtest.h>

#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/world_access.h"
#include "tests/support/world_builder.h"

namespace jostle::test {
namespace {
using namespace physics;

struct Borne {
    double total = 0, mean_impulse = 0;
};

// A box of 1 m that lies on another, and the contact between them.
struct TwoBoxes {
    World world = make_world({.sleeping = false});
    std::uint32_t contact = 0;

    TwoBoxes() {
        add_floor(world);
        add(world, {.position = {0, 0.5, 0}});
        const BodyId upper = add(world, {.position = {0, 1.5, 0}});
        run(world, 5);
        for_each_contact(state().contacts, state().bodies.cold[upper.index],
                         [&](std::uint32_t index) { contact = index; });
    }
    WorldState& state() { return state_of(world); }
    ContactLaneRef place() {
        return lane_ref_of(state().graph, state().contacts.contacts[contact]);
    }
    Borne borne() {
        Borne sum;
        for (int k = 0; k < 4; k++) {
            sum.total += double{place().block->lambda[k][place().lane]};
            sum.mean_impulse += double{place().block->mean_impulse[k][place().lane]};
        }
        return sum;
    }
    void rebuild(std::initializer_list<Vec3> points) {
        Manifold m{.normal = normal_of(place())};
        for (const Vec3 point : points) m.point[m.count++] = point;
        write_manifold(state(), state().contacts.contacts[contact], m, false);
    }
};

TEST(WriteManifold, transfers_the_load_to_new_points) {
    TwoBoxes boxes;
    const Borne before = boxes.borne();
    const double weight = 1000 * 9.81 / (60 * 4);  // N s per sub-step: it is flat
    ASSERT_NEAR(before.total / weight, 1, 0.01);
    // Turned by half a right angle: no new point is near an old one.
    boxes.rebuild({{0.7, 1, 0}, {0, 1, 0.7}, {-0.7, 1, 0}, {0, 1, -0.7}});
    EXPECT_NEAR(boxes.borne().total, before.total, 1e-5 * before.total);
    EXPECT_NEAR(boxes.borne().mean_impulse, before.mean_impulse, 1e-5 * before.mean_impulse);
    // It stands on two corners, then on one.
    boxes.rebuild({{0.7, 1, 0}, {0, 1, 0.7}});
    EXPECT_NEAR(boxes.borne().total, before.total, 1e-5 * before.total);
    boxes.rebuild({{0.7, 1, 0}});
    EXPECT_NEAR(boxes.borne().total, before.total, 1e-5 * before.total);
    EXPECT_NEAR(boxes.borne().mean_impulse, before.mean_impulse, 1e-5 * before.mean_impulse);
    // New points bear nothing until they press.
    boxes.rebuild({{0.7, 1, 0}, {0, 1, 0.7}, {-0.7, 1, 0}});
    EXPECT_NEAR(boxes.borne().total, before.total, 1e-5 * before.total);
    EXPECT_NEAR(boxes.borne().mean_impulse, before.mean_impulse, 1e-5 * before.mean_impulse);
}

// A point within reach goes on with its own.
TEST(WriteManifold, keeps_the_load_of_a_slightly_moved_point) {
    TwoBoxes boxes;
    const float before = boxes.place().block->lambda[0][boxes.place().lane];
    ASSERT_GT(before, 0);
    std::vector<Vec3> corners;
    for (const ContactInfo& c : boxes.world.contacts())
        if (c.point[0].y > 0.9)
            for (int k = 0; k < c.count; k++) corners.push_back(c.point[k] + Vec3{0.01, 0, 0});
    ASSERT_EQ(corners.size(), 4u);
    boxes.rebuild({corners[3], corners[2], corners[1], corners[0]});
    EXPECT_EQ(boxes.place().block->lambda[3][boxes.place().lane], before);
}

// Four points of which one touches: what a body has for feet.
struct Foot {
    Vec3 arm;  // from its centre of mass
    double lever = 0;
};
Foot foot_of(const Geometry& geometry, double other_gaps) {
    World world = make_world();
    add_floor(world);
    const BodyId body = add(world, {.geometry = geometry, .position = {0, 0.1, 0}});
    run(world, 1.0 / 60);
    WorldState& state = state_of(world);
    std::uint32_t contact = 0;
    for_each_contact(state.contacts, state.bodies.cold[body.index],
                     [&](std::uint32_t index) { contact = index; });
    const Contact& c = state.contacts.contacts[contact];
    const ContactLaneRef place = lane_ref_of(state.graph, c);
    const Vec3 center = warm_of(state, c.body_a).center;
    Manifold m{.normal = normal_of(place)};
    m.count = 4;
    const Vec3 points[] = {{1, 0, 0}, {0, 0, 1}, {-1, 0, 0}, {0, 0, -1}};
    for (int k = 0; k < 4; k++) {
        m.point[k] = {points[k].x, 0, points[k].z};
        m.gap[k] = k == 0 ? 0 : other_gaps;
    }
    write_manifold(state, c, m, false);
    const auto arm = [&](int k) { return double{place.block->arm_a[k][place.lane]}; };
    return {Vec3{arm(0), arm(1), arm(2)} + center,
            double{place.block->friction_radius[place.lane]}};
}

// A disc that stands on its rim is held there, without a lever about the normal; one that lies, or
// that comes down in a moment, by all points. A box is held in the middle of its face in any case.
TEST(WriteManifold, keeps_the_contact_point_of_a_rim) {
    const Foot rim = foot_of(Cylinder{1, 0.1}, 0.01), flat = foot_of(Cylinder{1, 0.1}, 0.003),
               box = foot_of(Box{{1, 0.1, 1}}, 0.01);
    EXPECT_NEAR(length(Vec3{rim.arm.x, 0, rim.arm.z} - Vec3{1, 0, 0}), 0, 1e-5);
    EXPECT_NEAR(rim.lever, 0, 1e-6);
    for (const Foot& foot : {flat, box}) {
        EXPECT_NEAR(length(Vec3{foot.arm.x, 0, foot.arm.z}), 0, 1e-5);
        EXPECT_NEAR(foot.lever, 1, 1e-6);
    }
}

}  // namespace
}  // namespace jostle::test
