// SPDX-License-Identifier: MIT
//
// Portable: a scene that every engine under test can be given, and whose errors can be measured.
// One sphere, capsule or box a body, ball joints and hinges and shoulders within limits. What such
// a scene says is read here, in words that other engines share.
#pragma once

#include <variant>

#include "jostle/physics/result.h"
#include "jostle/scenes/scene.h"

namespace jostle::bench {

// Names the first body or joint that some engine could not be given, and why.
physics::Status check_portable(const scenes::SceneDescription& scene);

// The rest is about scenes that passed the check.

using Primitive = std::variant<physics::Sphere, physics::Capsule, physics::Box>;
Primitive primitive_of(const scenes::SceneBody& body);

bool is_static(const scenes::SceneBody& body);
bool collides(const scenes::SceneBody& body);  // with anything

// Mass and principal inertia of the body as a solid, about its own axes.
struct SolidMass {
    double mass = 0;        // kg
    physics::Vec3 inertia;  // kg m^2
};
SolidMass solid_mass(const scenes::SceneBody& body);

// Where a joint is at the start, in the world. A hinge turns about z, a shoulder points along x.
struct JointAxes {
    physics::Vec3 anchor, x, y, z;
};
JointAxes axes_of(const scenes::SceneDescription& scene, const scenes::SceneJoint& joint);

}  // namespace jostle::bench
