// SPDX-License-Identifier: MIT
//
// Portable scenes: all engines support them, and their errors can be measured. They contain bodies
// of spheres, capsules, boxes and hulls, static meshes, ball joints, hinges, which may have motors,
// and cone_twist joints.
// The functions convert such a scene to terms that all engines share.
#pragma once

#include <variant>
#include <vector>

#include "jostle/physics/result.h"
#include "jostle/scenes/scene.h"

namespace jostle::bench {

// Errors name the first body or joint that some engine does not support, and the reason.
physics::Status check_portable(const scenes::SceneDescription& scene);

// The following functions require a scene that passed the check.

using Primitive =
    std::variant<physics::Sphere, physics::Capsule, physics::Box, physics::Hull, physics::Mesh>;
struct Part {
    Primitive shape;
    physics::Transform pose;  // in the body
};
std::vector<Part> parts_of(const scenes::SceneBody& body);

bool is_dynamic(const scenes::SceneBody& body);
bool is_static(const scenes::SceneBody& body);
bool collides(const scenes::SceneBody& body);  // whether it collides with any body

// Mass properties of the body in its own frame; zero for bodies that are not dynamic.
struct SolidMass {
    double mass = 0;        // kg
    physics::Vec3 center;   // m
    physics::Mat3 inertia;  // kg m^2 about the centre
};
// As computed by Jostle, by body: each engine receives the same values.
physics::Result<std::vector<SolidMass>> solid_masses(const scenes::SceneDescription& scene);

// Initial frame of a joint in world space. A hinge turns about z, a cone_twist joint points along
// x.
struct JointAxes {
    physics::Vec3 anchor, x, y, z;
};
JointAxes axes_of(const scenes::SceneDescription& scene, const scenes::SceneJoint& joint);

}  // namespace jostle::bench
