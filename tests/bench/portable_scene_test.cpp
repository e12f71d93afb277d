// SPDX-License-Identifier: MIT
#include "bench/speed/portable_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>

#include "jostle/physics/mesh.h"
#include "scenes/src/scene_helpers.h"
#include "tests/support/near.h"

namespace {

using namespace jostle::bench;
using namespace jostle::physics;
using jostle::scenes::dynamic_body;
using jostle::scenes::fixed_box;
using jostle::scenes::join;
using jostle::scenes::SceneBody;
using jostle::scenes::SceneDescription;
using jostle::test::near;

// Two capsules end to end above a floor, connected where they touch.
SceneDescription elbow(const JointKind& kind = BallJoint{}) {
    SceneDescription scene{.bodies = {fixed_box("floor", {0, -1, 0}, {10, 1, 10}),
                                      dynamic_body("upper", {0, 3, 0}, Capsule{0.1, 0.4}),
                                      dynamic_body("lower", {0, 2, 0}, Capsule{0.1, 0.4})}};
    join(scene, "elbow", 1, 2, {{0, 2.5, 0}, from_axis_angle({0, 1, 0}, pi / 2)}, kind);
    return scene;
}

TEST(PortableScene, ball_hinge_motor_and_cone_joints_are_portable) {
    for (const JointKind& kind :
         {JointKind{BallJoint{}}, JointKind{HingeJoint{.limit = {true, -1, 1}}},
          JointKind{HingeJoint{}},
          JointKind{HingeJoint{.motor = {.enabled = true, .speed = 9, .max_torque = 120}}},
          JointKind{ConeTwistJoint{.swing = 0.5, .twist = {true, -1, 1}}}}) {
        const auto status = check_portable(elbow(kind));
        EXPECT_TRUE(status.ok()) << status.error().message;
    }
}

TEST(PortableScene, errors_name_what_is_not_portable) {
    static constexpr Vec3 corners[] = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    static constexpr std::array<std::uint32_t, 3> triangle[] = {{0, 2, 1}};
    const struct {
        std::function<void(SceneDescription&)> change;
        const char* message;
    } cases[] = {
        {[](auto& s) { s.bodies[1].shapes[0].geometry = Cylinder{}; },
         "bodies[1] 'upper' must be a sphere, capsule, box, hull or mesh"},
        {[](auto& s) {
             s.bodies[1].shapes.push_back({.geometry = Box{}, .material = {.friction = 0.1}});
         },
         "bodies[1] 'upper' has shapes with different friction"},
        {[](auto& s) { s.bodies[1].shapes.push_back({.geometry = Box{}, .filter = {.mask = 0}}); },
         "bodies[1] 'upper' has shapes with different filters"},
        {[](auto& s) { s.bodies[1].shapes[0].geometry = Mesh{*build_mesh(corners, triangle)}; },
         "bodies[1] 'upper' is a mesh that is not static"},
        {[](auto& s) { s.bodies[2].shapes[0].material.restitution = 1; },
         "bodies[2] 'lower' has a material with more than friction"},
        {[](auto& s) { s.bodies[2].shapes[0].filter.group = -1; },
         "bodies[2] 'lower' has a collision filter"},
        {[](auto& s) { s.bodies[2].body.locks = 1; }, "bodies[2] 'lower' has locked axes"},
        {[](auto& s) { s.joints[0].joint.break_force = 1; }, "joints[0] 'elbow' is breakable"},
        {[](auto& s) { s.joints[0].joint.frame_a.position.x = 0.01; },
         "joints[0] 'elbow' has anchors that are apart at the start"},
        {[](auto& s) { s.joints[0].joint.kind = FixedJoint{}; },
         "joints[0] 'elbow' must be a ball, hinge or cone_twist joint"},
        {[](auto& s) { s.joints[0].joint.kind = HingeJoint{.spring = {.hertz = 1}}; },
         "joints[0] 'elbow' is a hinge with more than limits and a motor"},
        {[](auto& s) {
             s.joints[0].joint.kind = HingeJoint{.limit = {true, -1, 1}};
             s.joints[0].joint.frame_b.rotation = {};
         },
         "joints[0] 'elbow' has misaligned frames at the start"},
        {[](auto& s) { s.world.planar = true; }, "world: is planar"},
    };
    for (const auto& [change, message] : cases) {
        SceneDescription scene = elbow();
        change(scene);
        const auto status = check_portable(scene);
        ASSERT_FALSE(status.ok()) << message;
        EXPECT_EQ(status.error().message.substr(0, std::string_view(message).size()), message);
    }
}

TEST(PortableScene, joint_axes_are_in_world_space) {
    const SceneDescription scene = elbow();
    const JointAxes axes = axes_of(scene, scene.joints[0]);
    EXPECT_TRUE(near(axes.anchor, {0, 2.5, 0}, 1e-13));
    EXPECT_TRUE(near(axes.x, {0, 0, -1}, 1e-13));
    EXPECT_TRUE(near(axes.y, {0, 1, 0}, 1e-13));
    EXPECT_TRUE(near(axes.z, {1, 0, 0}, 1e-13));
}

TEST(PortableScene, masses_match_solid_bodies) {
    SceneDescription scene{.bodies = {fixed_box("floor", {0, -1, 0}, {10, 1, 10}),
                                      dynamic_body("ball", {1, 2, 3}, Sphere{0.3}),
                                      dynamic_body("L", {5, 5, 5}, Box{{0.5, 0.1, 0.1}},
                                                   from_axis_angle({1, 2, 3}, 1))}};
    scene.bodies[2].shapes.push_back(
        {.geometry = Box{{0.1, 0.1, 0.1}}, .pose = {{0.4, 0.2, 0}, {}}});
    for (std::size_t k = 1; k < 3; k++)
        for (ShapeDef& shape : scene.bodies[k].shapes) shape.density = 700;
    const auto masses = *solid_masses(scene);
    ASSERT_EQ(masses.size(), 3u);
    EXPECT_EQ(masses[0].mass, 0);
    const double ball = 700 * 4 / 3.0 * pi * 0.027;
    EXPECT_NEAR(masses[1].mass, ball, 1e-9 * ball);
    EXPECT_NEAR(masses[1].inertia.x.x, 0.4 * ball * 0.09, 1e-9 * ball);
    // A bar of 28 kg and a cube of 5.6 kg above its end, with 1/6 of the total mass.
    EXPECT_NEAR(masses[2].mass, 33.6, 1e-9);
    EXPECT_TRUE(near(masses[2].center, {0.4 / 6, 0.2 / 6, 0}, 1e-12));
    const double apart = 28 * 5.6 / 33.6;  // reduced mass, kg
    EXPECT_NEAR(masses[2].inertia.z.z,
                28 * (0.25 + 0.01) / 3 + 5.6 * 0.02 / 3 + apart * (0.16 + 0.04), 1e-9);
    EXPECT_NEAR(masses[2].inertia.x.y, -apart * 0.4 * 0.2, 1e-9);
}

}  // namespace
