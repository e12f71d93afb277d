// SPDX-License-Identifier: MIT
//
// Portable: a scene that other engines can be given, and whose errors can be measured. Bodies of
// spheres, capsules, boxes and hulls, meshes that stay, ball joints, hinges and shoulders. What
// such a scene says is read here, in words that other engines share.
#pragma once

#include <variant>
#include <vector>

#include "jostle/physics/result.h"
#include "jostle/scenes/scene.h"

namespace jostle::bench {

// Names the first body or joint that some engine could not be given, and why.
physics::Status check_portable(const scenes::SceneDescription& scene);

// The rest is about scenes that passed the check.

using Primitive =
    std::variant<physics::Sphere, physics::Capsule, physics::Box, physics::Hull, physics::Mesh>;
struct Part {
    Primitive shape;
    physics::Transform pose;  // in the body
};
std::vector<Part> parts_of(const scenes::SceneBody& body);

bool is_dynamic(const scenes::SceneBody& body);
bool is_static(const scenes::SceneBody& body);
bool collides(const scenes::SceneBody& body);  // with anything

// Of the body as a solid, in its own frame; zero for what is not dynamic.
struct SolidMass {
    double mass = 0;        // kg
    physics::Vec3 center;   // m
    physics::Mat3 inertia;  // kg m^2 about the centre
};
// As Jostle finds them, by body: each engine gets the same.
physics::Result<std::vector<SolidMass>> solid_masses(const scenes::SceneDescription& scene);

// Where a joint is at the start, in the world. A hinge turns about z, a shoulder points along x.
struct JointAxes {
    physics::Vec3 anchor, x, y, z;
};
JointAxes axes_of(const scenes::SceneDescription& scene, const scenes::SceneJoint& joint);

}  // namespace jostle::bench
