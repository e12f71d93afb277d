// SPDX-License-Identifier: MIT
//
// Compares the accuracy check with closed-form solutions.
#include "bench/speed/accuracy_check.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "jostle/physics/hull.h"
#include "jostle/physics/mesh.h"
#include "scenes/src/scene_helpers.h"
#include "tests/support/random.h"

namespace {

using namespace jostle::bench;
namespace scenes = jostle::scenes;
using jostle::physics::Box;
using jostle::physics::Capsule;
using jostle::physics::compose;
using jostle::physics::from_axis_angle;
using jostle::physics::Hull;
using jostle::physics::Mesh;
using jostle::physics::Quat;
using jostle::physics::Sphere;
using jostle::physics::Transform;
using jostle::physics::Vec3;

constexpr double pi = jostle::physics::pi, exact = 1e-9;

const Box cube{{0.5, 0.5, 0.5}};
const Quat eighth_about_z = from_axis_angle({0, 0, 1}, pi / 4);

Transform at(Vec3 position, Quat rotation = {}) {
    return {position, rotation};
}

// Also checks that the depth is independent of the pose of the pair and of the order of the shapes.
double depth(const Primitive& a, const Transform& pose_a, const Primitive& b,
             const Transform& pose_b) {
    const double here = penetration_depth(a, pose_a, b, pose_b);
    const Transform moved{{3, -2, 7}, from_axis_angle({1, 2, -3}, 1.234)};
    EXPECT_NEAR(penetration_depth(a, compose(moved, pose_a), b, compose(moved, pose_b)), here,
                exact);
    EXPECT_NEAR(penetration_depth(b, pose_b, a, pose_a), here, exact);
    return here;
}

TEST(AccuracyCheck, measures_face_to_face_boxes) {
    EXPECT_NEAR(depth(cube, at({}), cube, at({0, 0.999, 0})), 0.001, exact);
    EXPECT_LE(depth(cube, at({}), cube, at({0, 1.001, 0})), 0);
}

Hull hull_of(const Box& box) {
    std::vector<Vec3> corners;
    for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0})
            for (const double z : {-1.0, 1.0}) {
                const Vec3 h = box.half_extents;
                corners.push_back({x * h.x, y * h.y, z * h.z});
            }
    return Hull{*jostle::physics::build_hull(corners)};
}

// A hull with the corners of a box has the same depth as the box, against all convex shapes.
TEST(AccuracyCheck, box_shaped_hulls_match_boxes) {
    jostle::test::Random random(5);
    const Box brick{{0.3, 0.25, 0.35}};
    const Primitive others[] = {Sphere{0.3}, Capsule{0.2, 0.25}, brick};
    int overlapping = 0;
    for (int k = 0; k < 200; k++) {
        const Transform here{random.vector(0.4), random.rotation()},
            there{random.vector(0.4), random.rotation()};
        const double truth = penetration_depth(brick, here, others[k % 3], there);
        if (truth <= 0) continue;
        overlapping++;
        EXPECT_NEAR(penetration_depth(hull_of(brick), here, others[k % 3], there), truth, exact)
            << k;
        if (k % 3 != 2) continue;
        EXPECT_NEAR(penetration_depth(hull_of(brick), here, hull_of(brick), there), truth, exact)
            << k;
    }
    EXPECT_GT(overlapping, 50);
}

// Level ground of two triangles: detects a shape 3 cm below it, but none above or outside of it.
TEST(AccuracyCheck, measures_depth_below_a_mesh) {
    const Vec3 corners[] = {{-5, 0, -5}, {5, 0, -5}, {5, 0, 5}, {-5, 0, 5}};
    const std::array<std::uint32_t, 3> triangles[] = {{0, 2, 1}, {0, 3, 2}};
    const Mesh ground{*jostle::physics::build_mesh(corners, triangles)};
    const Transform at_ground{{1, 2, 3}, {}};
    const auto below = [&](const Primitive& shape, double lowest_of_shape, double x = 2) {
        return penetration_depth(shape, at({x, 2 + lowest_of_shape - 0.03, 3.5}), ground,
                                 at_ground);
    };
    for (const auto& [shape, reach] : {std::pair<Primitive, double>{Sphere{0.3}, 0.3},
                                       {Capsule{0.1, 0.2}, 0.3},
                                       {Box{{0.1, 0.3, 0.1}}, 0.3},
                                       {hull_of(Box{{0.1, 0.3, 0.1}}), 0.3}}) {
        EXPECT_NEAR(below(shape, reach), 0.03, 1e-12);
        EXPECT_LE(below(shape, reach + 0.04), 0);
        EXPECT_LE(below(shape, reach, 20), 0);
    }
}

TEST(AccuracyCheck, measures_a_box_on_its_edge) {
    // Half the diagonal is sqrt(2)/2; the edge is 1 mm below the other box's top face at 0.5.
    const double height = 0.5 + std::sqrt(0.5) - 0.001;
    EXPECT_NEAR(depth(cube, at({}), cube, at({0.1, height, 0}, eighth_about_z)), 0.001, exact);
}

TEST(AccuracyCheck, measures_crossed_box_edges) {
    // Two edges, one along z and one along x, cross on the y axis.
    const Quat eighth_about_x = from_axis_angle({1, 0, 0}, pi / 4);
    const double height = 2 * std::sqrt(0.5) - 0.001;
    EXPECT_NEAR(depth(cube, at({}, eighth_about_z), cube, at({0, height, 0}, eighth_about_x)),
                0.001, exact);
}

TEST(AccuracyCheck, measures_sphere_against_face_edge_corner_and_inside) {
    const Sphere ball{0.3};
    EXPECT_NEAR(depth(ball, at({0.1, 0.79, 0}), cube, at({})), 0.01, exact);
    EXPECT_NEAR(depth(ball, at({0.6, 0.6, 0}), cube, at({})), 0.3 - 0.1 * std::sqrt(2), exact);
    EXPECT_NEAR(depth(ball, at({0.6, 0.6, 0.6}), cube, at({})), 0.3 - 0.1 * std::sqrt(3), exact);
    EXPECT_NEAR(depth(ball, at({0.4, 0, 0}), cube, at({})), 0.3 + 0.1, exact);
}

TEST(AccuracyCheck, measures_spheres) {
    EXPECT_NEAR(depth(Sphere{0.3}, at({}), Sphere{0.2}, at({0.3, 0.39, 0})),
                0.5 - std::sqrt(0.09 + 0.39 * 0.39), exact);
}

TEST(AccuracyCheck, measures_parallel_crossed_and_collinear_capsules) {
    const Capsule rod{0.2, 1};
    const Quat along_x = from_axis_angle({0, 0, 1}, pi / 2);
    EXPECT_NEAR(depth(rod, at({}), rod, at({0.399, 0.7, 0})), 0.001, exact);
    EXPECT_NEAR(depth(rod, at({}), rod, at({0, 0, 0.39}, along_x)), 0.01, exact);
    EXPECT_NEAR(depth(rod, at({}), rod, at({0, 2.395, 0})), 0.005, exact);
    EXPECT_NEAR(depth(rod, at({}), Sphere{0.1}, at({0.29, -0.4, 0})), 0.01, exact);
}

TEST(AccuracyCheck, measures_lying_standing_and_leaning_capsules_on_a_box) {
    const Capsule rod{0.2, 1};
    const Quat along_x = from_axis_angle({0, 0, 1}, pi / 2);
    EXPECT_NEAR(depth(rod, at({0.3, 0.698, 0}, along_x), cube, at({})), 0.002, exact);
    EXPECT_NEAR(depth(rod, at({0.3, 1.698, 0}), cube, at({})), 0.002, exact);
    // At 45 degrees above the edge at (0.5, 0.5): the distance from the axis to the edge is 0.19.
    const double over = 0.5 + 0.19 * std::sqrt(0.5);
    EXPECT_NEAR(depth(rod, at({over, over, 0}, eighth_about_z), cube, at({})), 0.01, exact);
}

TEST(AccuracyCheck, measures_capsule_with_its_axis_inside_a_box) {
    // The axis is 0.1 below the top face; the depth is 0.1 plus the radius.
    const Quat along_x = from_axis_angle({0, 0, 1}, pi / 2);
    EXPECT_NEAR(depth(Capsule{0.2, 0.3}, at({0, 0.4, 0}, along_x), cube, at({})), 0.3, exact);
}

// Projected radius of a shape along a unit vector.
double reach(const Primitive& shape, const Transform& pose, Vec3 along) {
    const Vec3 local = inverse_rotate(pose.rotation, along);
    if (const auto* sphere = std::get_if<Sphere>(&shape)) return sphere->radius;
    if (const auto* rod = std::get_if<Capsule>(&shape))
        return rod->radius + rod->half_length * std::abs(local.y);
    return dot(abs(local), std::get<Box>(shape).half_extents);
}

// The overlap of two shapes is the smallest overlap of their projections over all directions. This
// function searches many random directions and refines the best one, as an independent method.
double least_projection(const Primitive& a, const Transform& pose_a, const Primitive& b,
                        const Transform& pose_b) {
    const Vec3 between = pose_b.position - pose_a.position;
    const auto overlap_along = [&](Vec3 n) {
        return reach(a, pose_a, n) + reach(b, pose_b, n) - std::abs(dot(between, n));
    };
    jostle::test::Random random(7);
    Vec3 best{0, 1, 0};
    const auto try_axis = [&](Vec3 n) {
        if (overlap_along(n) < overlap_along(best)) best = n;
    };
    for (int k = 0; k < 10000; k++) try_axis(random.direction());
    for (double size = 0.1; size > 1e-6; size *= 0.99)
        for (int k = 0; k < 3; k++) try_axis(normalized(best + random.vector(size)));
    return overlap_along(best);
}

TEST(AccuracyCheck, matches_a_brute_force_direction_search) {
    jostle::test::Random random(3);
    const Primitive shapes[] = {Sphere{0.3}, Capsule{0.2, 0.25}, Box{{0.3, 0.25, 0.35}}};
    int overlapping = 0;
    for (int k = 0; k < 300; k++) {
        const Primitive &a = shapes[k % 3], &b = shapes[k / 3 % 3];
        const Transform pose_a = at({}, random.rotation());
        const Transform pose_b = at(random.vector(0.4), random.rotation());
        const double searched = least_projection(a, pose_a, b, pose_b);
        const double exact_depth = penetration_depth(a, pose_a, b, pose_b);
        if (exact_depth <= 0) continue;
        overlapping++;
        ASSERT_LE(exact_depth, searched + exact);
        ASSERT_NEAR(exact_depth, searched, 5e-3) << a.index() << " " << b.index();
    }
    EXPECT_GT(overlapping, 200);
}

// Two spheres, each 4 mm deep in the floor and 20 mm in the other sphere.
struct ThreeBodies {
    scenes::SceneDescription scene;
    std::vector<Transform> poses;

    ThreeBodies() {
        scene.bodies = {scenes::fixed_box("floor", {0, -1, 0}, {10, 1, 10}),
                        scenes::dynamic_body("left", {0, 0.496, 0}, Sphere{0.5}),
                        scenes::dynamic_body("right", {0.98, 0.496, 0}, Sphere{0.5})};
        for (const scenes::SceneBody& body : scene.bodies) poses.push_back(body.body.pose);
    }
};

TEST(AccuracyCheck, sums_penetration_over_a_scene) {
    ThreeBodies three;
    const Penetration both = AccuracyCheck(three.scene).penetration(three.poses);
    EXPECT_EQ(both.pairs, 3);
    EXPECT_EQ(both.over_1cm, 1);
    EXPECT_NEAR(both.deepest, 0.02, exact);
    EXPECT_NEAR(both.mean, (0.004 + 0.004 + 0.02) / 3, exact);
}

TEST(AccuracyCheck, skips_jointed_pairs_and_measures_joint_drift) {
    ThreeBodies three;
    scenes::join(three.scene, "link", 2, 1, at({0.5, 0.496, 0}), jostle::physics::BallJoint{});
    const AccuracyCheck check(three.scene);
    EXPECT_EQ(check.penetration(three.poses).over_1cm, 0);
    EXPECT_NEAR(check.joint_drift(three.poses), 0, exact);
    three.poses[2].position += {0.003, 0, 0.004};
    EXPECT_NEAR(check.joint_drift(three.poses), 0.005, exact);
    // A rotation moves the anchor around the body's centre, 0.48 m away; the distance is a chord.
    three.poses[2] = {three.scene.bodies[2].body.pose.position, from_axis_angle({0, 1, 0}, pi / 2)};
    EXPECT_NEAR(check.joint_drift(three.poses), 0.48 * std::sqrt(2), exact);
}

TEST(AccuracyCheck, skips_bodies_that_collide_with_nothing) {
    ThreeBodies three;
    three.scene.bodies[2].shapes[0].filter.mask = 0;
    EXPECT_EQ(AccuracyCheck(three.scene).penetration(three.poses).pairs, 1);
}

TEST(AccuracyCheck, counts_lost_bodies_and_continues) {
    ThreeBodies three;
    three.poses[2].position.x = std::numeric_limits<double>::quiet_NaN();
    const Penetration found = AccuracyCheck(three.scene).penetration(three.poses);
    EXPECT_EQ(found.lost, 1);
    EXPECT_EQ(found.pairs, 1);
}

}  // namespace
