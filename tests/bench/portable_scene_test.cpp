// SPDX-License-Identifier: MIT
#include "speed/portable_scene.h"

#include <gtest/gtest.h>

#include <functional>

#include "parts.h"
#include "support/near.h"

namespace {

using namespace jostle::bench;
using namespace jostle::physics;
using jostle::scenes::fixed_box;
using jostle::scenes::join;
using jostle::scenes::loose;
using jostle::scenes::SceneBody;
using jostle::scenes::SceneDescription;
using jostle::test::near;

// Two capsules end to end over a floor, joined where they meet.
SceneDescription elbow(const JointKind& kind = BallJoint{}) {
    SceneDescription scene{.bodies = {fixed_box("floor", {0, -1, 0}, {10, 1, 10}),
                                      loose("upper", {0, 3, 0}, Capsule{0.1, 0.4}),
                                      loose("lower", {0, 2, 0}, Capsule{0.1, 0.4})}};
    join(scene, "elbow", 1, 2, {{0, 2.5, 0}, from_axis_angle({0, 1, 0}, pi / 2)}, kind);
    return scene;
}

TEST(PortableScene, balls_hinges_and_shoulders_within_limits_are_portable) {
    for (const JointKind& kind :
         {JointKind{BallJoint{}}, JointKind{HingeJoint{.limit = {true, -1, 1}}},
          JointKind{ConeTwistJoint{.swing = 0.5, .twist = {true, -1, 1}}}}) {
        const auto status = check_portable(elbow(kind));
        EXPECT_TRUE(status.ok()) << status.error().message;
    }
}

TEST(PortableScene, what_other_engines_could_not_be_given_is_named) {
    const struct {
        std::function<void(SceneDescription&)> change;
        const char* message;
    } cases[] = {
        {[](auto& s) { s.bodies[1].shapes[0].geometry = Cylinder{}; },
         "bodies[1] 'upper' is no sphere, capsule or box"},
        {[](auto& s) { s.bodies[1].shapes.push_back({}); }, "bodies[1] 'upper' has not one shape"},
        {[](auto& s) { s.bodies[2].shapes[0].pose.position.x = 1; },
         "bodies[2] 'lower' has a shape that is off its middle"},
        {[](auto& s) { s.bodies[2].shapes[0].material.restitution = 1; },
         "bodies[2] 'lower' has a material of more than friction"},
        {[](auto& s) { s.bodies[2].shapes[0].filter.group = -1; },
         "bodies[2] 'lower' collides with some"},
        {[](auto& s) { s.bodies[2].body.type = BodyType::kinematic; },
         "bodies[2] 'lower' is kinematic"},
        {[](auto& s) { s.joints[0].joint.break_force = 1; }, "joints[0] 'elbow' breaks"},
        {[](auto& s) { s.joints[0].joint.frame_a.position.x = 0.01; },
         "joints[0] 'elbow' has ends that are apart at the start"},
        {[](auto& s) { s.joints[0].joint.kind = FixedJoint{}; },
         "joints[0] 'elbow' is no ball, hinge or cone_twist"},
        {[](auto& s) { s.joints[0].joint.kind = HingeJoint{}; },
         "joints[0] 'elbow' is a hinge of more than limits, or without"},
        {[](auto& s) {
             s.joints[0].joint.kind = HingeJoint{.limit = {true, -1, 1}};
             s.joints[0].joint.frame_b.rotation = {};
         },
         "joints[0] 'elbow' has ends that are turned against each other at the start"},
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

TEST(PortableScene, axes_of_a_joint_are_in_the_world) {
    const SceneDescription scene = elbow();
    const JointAxes axes = axes_of(scene, scene.joints[0]);
    EXPECT_TRUE(near(axes.anchor, {0, 2.5, 0}, 1e-13));
    EXPECT_TRUE(near(axes.x, {0, 0, -1}, 1e-13));
    EXPECT_TRUE(near(axes.y, {0, 1, 0}, 1e-13));
    EXPECT_TRUE(near(axes.z, {1, 0, 0}, 1e-13));
}

TEST(PortableScene, masses_are_those_of_solid_bodies) {
    for (const Geometry& geometry :
         {Geometry{Sphere{0.3}}, Geometry{Box{{0.3, 0.25, 0.35}}}, Geometry{Capsule{0.2, 0.25}}}) {
        auto world = std::move(*World::create());
        SceneBody described = loose("body", {}, geometry);
        described.shapes[0].density = 700;
        const auto body = *world.body(*world.create_body(described.body, described.shapes[0]));
        const SolidMass solid = solid_mass(described);
        EXPECT_NEAR(solid.mass, body.mass, 1e-9 * body.mass);
        const Vec3 turns{body.inertia.x.x, body.inertia.y.y, body.inertia.z.z};
        EXPECT_TRUE(near(solid.inertia, turns, 1e-9 * length(turns)));
    }
}

}  // namespace
