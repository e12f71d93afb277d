// SPDX-License-Identifier: MIT
//
// The benchmark scenes match their definitions exactly, so that results remain comparable over time
// and with other engines.
#include "jostle/scenes/bench_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "jostle/scenes/catalog.h"
#include "tests/support/near.h"

namespace jostle::scenes {
namespace {

using namespace physics;
using test::near;

bool is_fixed(const SceneBody& body) {
    return body.body.type == BodyType::static_body;
}

Vec3 position(const SceneBody& body) {
    return body.body.pose.position;
}

template <class Shape>
Shape shape(const SceneBody& body) {
    return std::get<Shape>(body.shapes.at(0).geometry);
}

// A second implementation of the generator in the definition.
struct Draws {
    std::uint32_t s = 12345;
    double operator()(double a, double b) {
        s = s * 1664525 + 1013904223;
        return a + (b - a) * ((s >> 8) / 16777216.0);
    }
};

struct Expected {
    const char* name;
    std::size_t bodies, joints, fixed;
    Vec3 first, last;  // of dynamic bodies
};

const Expected expected[] = {
    {"bench_pyramid_465", 466, 0, 1, {-14.5 * 1.05, 0.5, 0}, {0, 29.5, 0}},
    {"bench_pyramid_5050", 5051, 0, 1, {-49.5, 0.5, 0}, {0, 99.5, 0}},
    {"bench_player_901", 902, 0, 1, {-14.5, 0.2, -14.5}, {-18, 0.75, 0}},
    {"bench_joint_grid_10000", 10000, 19794, 7, {0, 0, 0}, {99, -99, 0}},
    {"bench_chain", 1000, 999, 1, {0.5, 0, 0}, {499.5, 0, 0}},
    {"bench_vehicles",
     501,
     400,
     1,
     {-36, 0.5 * (std::sin(-5.4) + std::sin(-15.2)) + 1.6, -76},
     {37, 0.5 * (std::sin(5.4) + std::sin(-0.8)) + 1.35, -2.7}},
    {"bench_brick_wall", 402, 0, 1, {-4.875, 0.125, 0}, {0, 2, 8}},
    {"bench_convex_pile", 5125, 0, 5, {-4.5, 0.4, -4.5}, {4.5, 11.8, 4.5}},
    {"bench_junkyard", 10590, 0, 5, {0, 0.6, 0}, {7, 17.7, 7}},
    {"bench_asleep_10000", 10001, 0, 1, {-99, 0.5, -99}, {99, 0.5, 99}},
};

TEST(BenchScenes, body_and_joint_counts_and_extents) {
    for (const Expected& e : expected) {
        SCOPED_TRACE(e.name);
        const SceneDescription s = *find_scene(e.name);
        EXPECT_EQ(s.bodies.size(), e.bodies);
        EXPECT_EQ(s.joints.size(), e.joints);
        EXPECT_EQ(std::count_if(s.bodies.begin(), s.bodies.end(), is_fixed),
                  static_cast<std::ptrdiff_t>(e.fixed));
        const auto first = std::find_if_not(s.bodies.begin(), s.bodies.end(), is_fixed);
        EXPECT_TRUE(near(position(*first), e.first, 1e-12));
        EXPECT_TRUE(near(position(s.bodies.back()), e.last, 1e-12));
    }
}

TEST(BenchScenes, gravity_density_friction_and_damping_are_uniform) {
    int scenes = 0;
    for (const CatalogEntry& entry : catalog()) {
        if (!entry.name.starts_with("bench_")) continue;
        scenes++;
        SCOPED_TRACE(entry.name);
        const SceneDescription scene = *find_scene(entry.name);
        EXPECT_EQ(scene.hz, 60);
        EXPECT_EQ(scene.world.gravity, (Vec3{0, -9.81, 0}));
        for (const SceneBody& body : scene.bodies) {
            for (const ShapeDef& shape : body.shapes) {
                ASSERT_EQ(shape.density, 1000);
                ASSERT_EQ(shape.material, (Material{.friction = 0.5, .restitution = 0}));
            }
            ASSERT_EQ(body.body.linear_damping, 0.05);
            ASSERT_EQ(body.body.angular_damping, 0.05);
        }
    }
    EXPECT_EQ(scenes, 21);
}

TEST(BenchScenes, floors_are_two_metres_thick) {
    for (const char* name :
         {"bench_pyramid_465", "bench_pyramid_5050", "bench_boxes_1000", "bench_pile_5000",
          "bench_player_901", "bench_ragdolls_40", "bench_asleep_10000", "bench_convex_pile",
          "bench_rods", "bench_brick_wall", "bench_l_shapes", "bench_junkyard"}) {
        const SceneBody floor = find_scene(name)->bodies[0];
        const double half = std::string_view(name) == "bench_asleep_10000" ? 250 : 200;
        EXPECT_EQ(shape<Box>(floor).half_extents, (Vec3{half, 1, half})) << name;
        EXPECT_EQ(floor.body.pose, (Transform{{0, -1, 0}, {}})) << name;
        EXPECT_TRUE(is_fixed(floor)) << name;
    }
}

TEST(BenchScenes, dropped_boxes_are_placed_by_the_random_sequence) {
    const SceneDescription c = *find_scene("bench_boxes_1000");
    ASSERT_EQ(c.bodies.size(), 1001u);
    Draws draw;
    const double x = draw(-0.05, 0.05), z = draw(-0.05, 0.05);
    EXPECT_TRUE(near(position(c.bodies[1]), {-5.4 + x, 1.5, -5.4 + z}, 1e-12));
    double last_x = 0, last_z = 0;
    for (int k = 1; k < 1000; k++) {
        last_x = draw(-0.05, 0.05);
        last_z = draw(-0.05, 0.05);
    }
    EXPECT_TRUE(near(position(c.bodies[1000]), {5.4 + last_x, 12.3, 5.4 + last_z}, 1e-12));
}

TEST(BenchScenes, pile_has_mixed_shapes_and_walls) {
    const SceneDescription d = *find_scene("bench_pile_5000");
    ASSERT_EQ(d.bodies.size(), 5005u);
    EXPECT_EQ(shape<Box>(d.bodies[1]).half_extents, (Vec3{0.5, 10, 6}));
    EXPECT_EQ(position(d.bodies[1]), (Vec3{5.5, 10, 0}));
    EXPECT_EQ(shape<Box>(d.bodies[4]).half_extents, (Vec3{6, 10, 0.5}));
    EXPECT_EQ(position(d.bodies[4]), (Vec3{0, 10, -5.5}));
    EXPECT_EQ(shape<Sphere>(d.bodies[5]).radius, 0.3);
    EXPECT_EQ(shape<Box>(d.bodies[6]).half_extents, (Vec3{0.3, 0.25, 0.35}));
    EXPECT_EQ(shape<Capsule>(d.bodies[7]), (Capsule{0.2, 0.25}));
    // Six random numbers per body: x, z, the axis, the angle. The last body is number 4999 = 34 *
    // 144 + 103.
    Draws draw;
    const double x = draw(-0.03, 0.03), z = draw(-0.03, 0.03);
    EXPECT_TRUE(near(position(d.bodies[5]), {-4.125 + x, 0.6, -4.125 + z}, 1e-12));
    for (int k = 2; k < 6 * 4999; k++) draw(0, 1);
    const double last_x = draw(-0.03, 0.03), last_z = draw(-0.03, 0.03);
    EXPECT_TRUE(near(position(d.bodies.back()),
                     {(7 - 5.5) * 0.75 + last_x, 0.6 + 0.8 * 34, (8 - 5.5) * 0.75 + last_z},
                     1e-12));
    Vec3 axis;
    for (int k = 0; k < 3; k++) axis[k] = draw(-1, 1);
    EXPECT_EQ(d.bodies.back().body.pose.rotation, from_axis_angle(axis, draw(0, 2 * pi)));
}

TEST(BenchScenes, pile_depth_does_not_depend_on_the_count) {
    EXPECT_EQ(bench_pile(5000).bodies.back().body.pose,
              find_scene("bench_pile_5000")->bodies.back().body.pose);
    for (const int count : {500, 20000}) {
        const SceneDescription pile = bench_pile(count);
        ASSERT_EQ(pile.bodies.size(), static_cast<std::size_t>(count) + 5);
        const double inner = 2 * (position(pile.bodies[1]).x - 0.5);
        EXPECT_NEAR(inner * inner / count, 0.02, 1e-9);
        for (std::size_t k = 5; k < pile.bodies.size(); k++)
            ASSERT_LT(std::abs(position(pile.bodies[k]).x), inner / 2 - 0.52);
    }
}

TEST(BenchScenes, player_is_the_last_body) {
    const SceneDescription e = *find_scene("bench_player_901");
    EXPECT_EQ(e.bodies.back().name, "player");
    EXPECT_EQ(shape<Box>(e.bodies.back()).half_extents, (Vec3{0.75, 0.75, 0.75}));
}

TEST(BenchScenes, ragdoll_joints_lie_where_bones_meet) {
    const SceneDescription f = *find_scene("bench_ragdolls_40");
    ASSERT_EQ(f.bodies.size(), 441u);
    ASSERT_EQ(f.joints.size(), 400u);
    // The first: feet at (-0.6, 0.5, -0.6), leaning by 0.35 about x, with its pelvis 1 m up.
    EXPECT_TRUE(
        near(position(f.bodies[1]), {-0.6, 0.5 + std::cos(0.35), -0.6 + std::sin(0.35)}, 1e-12));
    // The last: heading 0.62831853 * 9 + 0.9, level 9, its right lower leg at (-0.1, 0.24, 0).
    const Vec3 low = rotate(from_axis_angle({1, 0, 0}, 0.35), {-0.1, 0.24, 0});
    const Vec3 leg = rotate(from_axis_angle({0, 1, 0}, 0.62831853 * 9 + 0.3 * 3), low);
    EXPECT_TRUE(near(position(f.bodies[440]), Vec3{0.6, 18.5, 0.6} + leg, 1e-12));
    for (const SceneJoint& joint : f.joints) {
        EXPECT_LT(joint.body_a, joint.body_b);
        const Transform a = compose(f.bodies[joint.body_a].body.pose, joint.joint.frame_a);
        const Transform b = compose(f.bodies[joint.body_b].body.pose, joint.joint.frame_b);
        EXPECT_TRUE(near(a.position, b.position, 1e-12));
        EXPECT_NEAR((conjugate(a.rotation) * b.rotation).w, 1, 1e-12);
    }
    const auto limit = [&](std::size_t joint) {
        return std::get<HingeJoint>(f.joints[joint].joint.kind).limit;
    };
    EXPECT_NEAR(limit(4).lower, -120 * pi / 180, 1e-9);  // left elbow
    EXPECT_NEAR(limit(5).upper, 120 * pi / 180, 1e-9);   // right elbow
    const auto neck = std::get<ConeTwistJoint>(f.joints[1].joint.kind);
    EXPECT_NEAR(neck.swing, 35 * pi / 180, 1e-9);
    EXPECT_NEAR(neck.twist.lower, -45 * pi / 180, 1e-9);
}

TEST(BenchScenes, joint_grid_hangs_from_its_centre_and_does_not_collide) {
    const SceneDescription g = *find_scene("bench_joint_grid_10000");
    for (std::size_t k = 0; k < g.bodies.size(); k++) {
        ASSERT_FALSE(may_collide(g.bodies[k].shapes[0].filter, Filter{}));
        ASSERT_EQ(is_fixed(g.bodies[k]), k % 100 == 0 && k / 100 >= 47 && k / 100 <= 53);
    }
    for (const SceneJoint& joint : g.joints)
        ASSERT_FALSE(is_fixed(g.bodies[joint.body_a]) && is_fixed(g.bodies[joint.body_b]));
    EXPECT_EQ(g.joints[0].joint.frame_a.position, (Vec3{0, -0.5, 0}));
    EXPECT_EQ(g.joints[0].joint.frame_b.position, (Vec3{0, 0.5, 0}));
}

TEST(BenchScenes, bullets_are_aimed_at_the_wall) {
    const SceneDescription i = *find_scene("bench_bullets_1000");
    ASSERT_EQ(i.bodies.size(), 1001u);
    EXPECT_EQ(shape<Box>(i.bodies[0]).half_extents, (Vec3{0.025, 10, 10}));
    Draws draw;
    EXPECT_TRUE(near(position(i.bodies[1]), {draw(-15, -5), -7.75, -7.75}, 1e-12));
    for (int k = 1; k < 999; k++) draw(-15, -5);
    EXPECT_TRUE(near(position(i.bodies[1000]), {draw(-15, -5), -4.25, 7.75}, 1e-12));
    EXPECT_EQ(i.bodies[1000].body.linear_velocity, (Vec3{200, 0, 0}));
}

TEST(BenchScenes, vehicles_drive_both_ways_on_motors) {
    const SceneDescription s = bench_wheels(4);
    ASSERT_EQ(s.bodies.size(), 301u);
    EXPECT_TRUE(near(position(s.bodies[1]), {-36, 2.4, -20}, 1e-12));
    EXPECT_EQ(shape<Box>(s.bodies[1]).half_extents, (Vec3{1.2, 0.25, 0.5}));
    EXPECT_TRUE(near(position(s.bodies[2]), {-36.425, 2.15, -20.8}, 1e-12));
    EXPECT_TRUE(near(position(s.bodies[5]), {-35.575, 2.15, -19.2}, 1e-12));
    EXPECT_EQ(s.bodies[1].shapes[0].density, 300);
    EXPECT_EQ(s.bodies[2].shapes[0].density, 400);
    EXPECT_EQ(s.bodies[2].shapes[0].material.friction, 0.9);
    const auto motor = [&](std::size_t joint) {
        return std::get<HingeJoint>(s.joints[joint].joint.kind).motor;
    };
    EXPECT_EQ(motor(0), (JointMotor{true, 9, 120}));
    EXPECT_EQ(motor(4), (JointMotor{true, -9, 120}));
    EXPECT_EQ(bench_wheels_mesh(4, 0.4).bodies[0].shapes[0].material.friction, 0.9);
}

TEST(BenchScenes, links_of_chains_are_400_mm_apart) {
    const SceneDescription hanging = bench_hanging_chain(100), level = bench_hinge_chain(100);
    EXPECT_TRUE(near(position(hanging.bodies.back()), {0, -0.45 - 0.4 * 99, 0}, 1e-12));
    EXPECT_EQ(hanging.bodies[51].body.linear_velocity, Vec3{});
    EXPECT_TRUE(
        near(hanging.bodies[52].body.linear_velocity, {3 * std::sin(0.02 * 51), 0, 0}, 1e-12));
    EXPECT_TRUE(near(position(level.bodies.back()), {0.25 + 0.4 * 99, 0, 0}, 1e-12));
    EXPECT_EQ(level.joints.size(), 100u);
    EXPECT_TRUE(std::holds_alternative<HingeJoint>(level.joints[0].joint.kind));
}

TEST(BenchScenes, trees_have_branches_of_three_levels) {
    const SceneDescription s = bench_joint_tree(3);
    EXPECT_EQ(s.bodies.size(), 3 * 89u);
    EXPECT_EQ(s.joints.size(), 3 * 88u);
    EXPECT_EQ(position(s.bodies[178]), (Vec3{28, 0, 0}));  // the third root
    EXPECT_TRUE(near(position(s.bodies[179]), {28, -0.25, 0}, 1e-12));
    EXPECT_NEAR(s.bodies[179].body.linear_velocity.x, 2 * std::sin(-0.25), 1e-12);
}

TEST(BenchScenes, debris_bursts_upwards_at_10_to_40_metres_per_second) {
    const SceneDescription s = bench_debris(1200);
    ASSERT_EQ(s.bodies.size(), 1201u);
    EXPECT_TRUE(near(position(s.bodies[1]), {-2.75, 0.4, -2.75}, 1e-12));
    EXPECT_TRUE(near(position(s.bodies[145]), {-2.75, 0.92, -2.75}, 1e-12));
    for (std::size_t k = 1; k < s.bodies.size(); k++) {
        const Vec3 v = s.bodies[k].body.linear_velocity;
        ASSERT_GE(length(v), 10);
        ASSERT_LE(length(v), 40);
        ASSERT_GT(v.y, 0);
    }
}

TEST(BenchScenes, depth_of_poured_bodies_does_not_depend_on_the_count) {
    for (const int count : {2500, 10000, 40000}) {
        const SceneDescription s = bench_spheres(count);
        const double inner = 2 * (position(s.bodies[1]).x - 0.5);
        EXPECT_NEAR(count / (inner * inner), 41, 1) << count;  // per m^2
    }
}

}  // namespace
}  // namespace jostle::scenes
