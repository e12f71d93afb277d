// SPDX-License-Identifier: MIT
//
// The scenes are what their definitions say, to the last digit: figures of other times and of other
// engines' authors are about the same bodies.
#include "speed/lab_scenes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "jostle/physics/world.h"
#include "support/near.h"

namespace {

using namespace jostle::bench;
using jostle::physics::Box;
using jostle::physics::Capsule;
using jostle::physics::Sphere;
using jostle::physics::Transform;
using jostle::physics::Vec3;
using jostle::test::near;

SceneDescription scene(const char* name) {
    return find_lab_scene(name)->build();
}

// The definition's generator, written a second time.
struct Draws {
    std::uint32_t s = 12345;
    double operator()(double a, double b) {
        s = s * 1664525 + 1013904223;
        return a + (b - a) * ((s >> 8) / 16777216.0);
    }
};

struct Expected {
    const char* letter;
    const char* name;
    std::size_t bodies, joints, fixed;
    int steps;
    Vec3 first, last;  // of the bodies that move
};

const Expected expected[] = {
    {"a", "pyramid-465", 466, 0, 1, 600, {-14.5 * 1.05, 0.5, 0}, {0, 29.5, 0}},
    {"b", "pyramid-5050", 5051, 0, 1, 600, {-49.5, 0.5, 0}, {0, 99.5, 0}},
    {"e", "player-901", 902, 0, 1, 600, {-14.5, 0.2, -14.5}, {-18, 0.75, 0}},
    {"g", "joint-grid-10000", 10000, 19794, 7, 600, {0, 0, 0}, {99, -99, 0}},
    {"h", "asleep-10000", 10001, 0, 1, 600, {-99, 0.5, -99}, {99, 0.5, 99}},
};

TEST(LabScenes, counts_and_corners) {
    for (const Expected& e : expected) {
        SCOPED_TRACE(e.letter);
        ASSERT_EQ(find_lab_scene(e.letter), find_lab_scene(e.name));
        const SceneDescription s = scene(e.letter);
        EXPECT_EQ(s.bodies.size(), e.bodies);
        EXPECT_EQ(s.joints.size(), e.joints);
        EXPECT_EQ(s.steps, e.steps);
        const auto fixed = [](const SceneBody& body) { return body.fixed; };
        EXPECT_EQ(std::count_if(s.bodies.begin(), s.bodies.end(), fixed),
                  static_cast<std::ptrdiff_t>(e.fixed));
        const auto first = std::find_if_not(s.bodies.begin(), s.bodies.end(), fixed);
        EXPECT_TRUE(near(first->pose.position, e.first, 1e-12));
        EXPECT_TRUE(near(s.bodies.back().pose.position, e.last, 1e-12));
    }
}

TEST(LabScenes, nine_of_them_and_no_other) {
    std::string letters;
    for (const LabScene& s : lab_scenes()) letters += s.letter;
    EXPECT_EQ(letters, "abcdefghi");
    EXPECT_EQ(find_lab_scene("j"), nullptr);
    EXPECT_EQ(find_lab_scene(""), nullptr);
}

TEST(LabScenes, floors_are_two_metres_thick) {
    for (const char* letter : {"a", "b", "c", "d", "e", "f", "h"}) {
        const SceneBody floor = scene(letter).bodies[0];
        const double half = letter[0] == 'h' ? 250 : 200;
        EXPECT_EQ(std::get<Box>(floor.form).half_extents, (Vec3{half, 1, half})) << letter;
        EXPECT_EQ(floor.pose, (Transform{{0, -1, 0}, {}})) << letter;
    }
}

TEST(LabScenes, dropped_boxes_stand_where_the_draws_say) {
    const SceneDescription c = scene("c");
    ASSERT_EQ(c.bodies.size(), 1001u);
    Draws draw;
    const double x = draw(-0.05, 0.05), z = draw(-0.05, 0.05);
    EXPECT_TRUE(near(c.bodies[1].pose.position, {-5.4 + x, 1.5, -5.4 + z}, 1e-12));
    double last_x = 0, last_z = 0;
    for (int k = 1; k < 1000; k++) {
        last_x = draw(-0.05, 0.05);
        last_z = draw(-0.05, 0.05);
    }
    EXPECT_TRUE(near(c.bodies[1000].pose.position, {5.4 + last_x, 12.3, 5.4 + last_z}, 1e-12));
}

TEST(LabScenes, pile_is_mixed_and_walled) {
    const SceneDescription d = scene("d");
    ASSERT_EQ(d.bodies.size(), 5005u);
    EXPECT_EQ(std::get<Box>(d.bodies[1].form).half_extents, (Vec3{0.5, 10, 6}));
    EXPECT_EQ(d.bodies[1].pose.position, (Vec3{5.5, 10, 0}));
    EXPECT_EQ(std::get<Box>(d.bodies[4].form).half_extents, (Vec3{6, 10, 0.5}));
    EXPECT_EQ(d.bodies[4].pose.position, (Vec3{0, 10, -5.5}));
    EXPECT_EQ(std::get<Sphere>(d.bodies[5].form).radius, 0.3);
    EXPECT_EQ(std::get<Box>(d.bodies[6].form).half_extents, (Vec3{0.3, 0.25, 0.35}));
    EXPECT_EQ(std::get<Capsule>(d.bodies[7].form), (Capsule{0.2, 0.25}));
    // Six draws a body: x, z, the axis, the angle. The last body is number 4999 = 34 * 144 + 103.
    Draws draw;
    const double x = draw(-0.03, 0.03), z = draw(-0.03, 0.03);
    EXPECT_TRUE(near(d.bodies[5].pose.position, {-4.125 + x, 0.6, -4.125 + z}, 1e-12));
    for (int k = 2; k < 6 * 4999; k++) draw(0, 1);
    const double last_x = draw(-0.03, 0.03), last_z = draw(-0.03, 0.03);
    EXPECT_TRUE(near(d.bodies.back().pose.position,
                     {(7 - 5.5) * 0.75 + last_x, 0.6 + 0.8 * 34, (8 - 5.5) * 0.75 + last_z},
                     1e-12));
    Vec3 axis;
    for (int k = 0; k < 3; k++) axis[k] = draw(-1, 1);
    const auto turned = jostle::physics::from_axis_angle(axis, draw(0, 2 * jostle::physics::pi));
    EXPECT_EQ(d.bodies.back().pose.rotation, turned);
}

TEST(LabScenes, piles_of_any_count_are_as_deep) {
    EXPECT_EQ(poured_pile(5000).bodies.back().pose, scene("d").bodies.back().pose);
    for (const int count : {500, 20000}) {
        const SceneDescription pile = poured_pile(count);
        ASSERT_EQ(pile.bodies.size(), static_cast<std::size_t>(count) + 5);
        const double inner = 2 * (pile.bodies[1].pose.position.x - 0.5);
        EXPECT_NEAR(inner * inner / count, 0.02, 1e-9);
        for (std::size_t k = 5; k < pile.bodies.size(); k++)
            ASSERT_LT(std::abs(pile.bodies[k].pose.position.x), inner / 2 - 0.52);
    }
}

TEST(LabScenes, ragdolls_are_joined_where_their_parts_meet) {
    const SceneDescription f = scene("f");
    ASSERT_EQ(f.bodies.size(), 441u);
    ASSERT_EQ(f.joints.size(), 400u);
    // The first: feet at (-0.6, 0.5, -0.6), leaning by 0.35 about x, its pelvis 1 m up.
    EXPECT_TRUE(near(f.bodies[1].pose.position, {-0.6, 0.5 + std::cos(0.35), -0.6 + std::sin(0.35)},
                     1e-12));
    // The last: heading 0.62831853 * 9 + 0.9, level 9, its right lower leg at (-0.1, 0.24, 0).
    const Vec3 low = rotate(jostle::physics::from_axis_angle({1, 0, 0}, 0.35), {-0.1, 0.24, 0});
    const Vec3 leg =
        rotate(jostle::physics::from_axis_angle({0, 1, 0}, 0.62831853 * 9 + 0.3 * 3), low);
    EXPECT_TRUE(near(f.bodies[440].pose.position, Vec3{0.6, 18.5, 0.6} + leg, 1e-12));
    for (const SceneJoint& joint : f.joints) {
        EXPECT_NEAR(length(joint.axis), 1, 1e-12);
        EXPECT_NEAR(dot(joint.axis, joint.normal), 0, 1e-12);
        EXPECT_LT(joint.a, joint.b);
    }
    EXPECT_NEAR(f.joints[4].lower, -120 * jostle::physics::pi / 180, 1e-9);  // left elbow
    EXPECT_NEAR(f.joints[5].upper, 120 * jostle::physics::pi / 180, 1e-9);   // right elbow
}

TEST(LabScenes, grid_hangs_from_its_middle_and_collides_with_nothing) {
    const SceneDescription g = scene("g");
    for (std::size_t k = 0; k < g.bodies.size(); k++) {
        const SceneBody& ball = g.bodies[k];
        ASSERT_FALSE(ball.collides);
        ASSERT_EQ(ball.fixed, k % 100 == 0 && k / 100 >= 47 && k / 100 <= 53);
    }
    for (const SceneJoint& joint : g.joints)
        ASSERT_FALSE(g.bodies[joint.a].fixed && g.bodies[joint.b].fixed);
    EXPECT_EQ(g.joints[0].anchor, (Vec3{0, -0.5, 0}));
}

TEST(LabScenes, bullets_fly_at_the_wall) {
    const SceneDescription i = scene("i");
    ASSERT_EQ(i.bodies.size(), 1001u);
    EXPECT_EQ(i.steps, 120);
    EXPECT_EQ(std::get<Box>(i.bodies[0].form).half_extents, (Vec3{0.025, 10, 10}));
    Draws draw;
    EXPECT_TRUE(near(i.bodies[1].pose.position, {draw(-15, -5), -7.75, -7.75}, 1e-12));
    for (int k = 1; k < 999; k++) draw(-15, -5);
    EXPECT_TRUE(near(i.bodies[1000].pose.position, {draw(-15, -5), -4.25, 7.75}, 1e-12));
    EXPECT_EQ(i.bodies[1000].velocity, (Vec3{200, 0, 0}));
    EXPECT_TRUE(i.bodies[1000].sweeps);
}

TEST(LabScenes, player_goes_straight_and_then_in_a_circle) {
    EXPECT_EQ(player_velocity(149), (Vec3{6, 0, 0}));
    const double turned = 0.8 * (300 / 60.0 - 2.5);
    EXPECT_TRUE(near(player_velocity(300), {6 * std::cos(turned), 0, 6 * std::sin(turned)}, 1e-12));
}

TEST(LabScenes, masses_are_those_of_solid_bodies) {
    for (const Form& form :
         {Form{Sphere{0.3}}, Form{Box{{0.3, 0.25, 0.35}}}, Form{Capsule{0.2, 0.25}}}) {
        auto world = std::move(*jostle::physics::World::create());
        jostle::physics::ShapeDef shape{.density = 1000};
        std::visit([&](const auto& f) { shape.geometry = f; }, form);
        const auto body = *world.body(*world.create_body({}, shape));
        const SolidMass solid = solid_mass(form);
        EXPECT_NEAR(solid.mass, body.mass, 1e-9 * body.mass);
        const Vec3 turns{body.inertia.x.x, body.inertia.y.y, body.inertia.z.z};
        EXPECT_TRUE(near(solid.inertia, turns, 1e-9 * length(turns)));
    }
}

}  // namespace
