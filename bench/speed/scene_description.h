// SPDX-License-Identifier: MIT
//
// A scene as every engine of the laboratory is given it: plain data, no engine's types beyond
// vectors and the three round or square shapes. Engines build it, the referee judges what became of
// it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "jostle/physics/geometry.h"
#include "jostle/physics/transform.h"

namespace jostle::bench {

// The same for all scenes and engines.
inline constexpr physics::Vec3 gravity{0, -9.81, 0};  // m/s^2
inline constexpr double step_seconds = 1.0 / 60;
inline constexpr double density = 1000;       // kg/m^3, solid
inline constexpr double pair_friction = 0.5;  // of the pair, however an engine combines two
inline constexpr double damping = 0.05;       // 1/s, of linear and angular velocity

using Form = std::variant<physics::Sphere, physics::Capsule, physics::Box>;

struct SceneBody {
    Form form;
    physics::Transform pose;
    physics::Vec3 velocity;  // m/s
    bool fixed = false;
    bool collides = true;
    bool sweeps = false;  // fast: engines whose sweeps must be asked for are asked
};

enum class SceneJointKind { ball, hinge, cone_twist };

struct SceneJoint {
    SceneJointKind kind = SceneJointKind::ball;
    std::uint32_t a = 0, b = 0;     // bodies; these two do not collide
    physics::Vec3 anchor;           // world, at the start
    physics::Vec3 axis{1, 0, 0};    // world: what a hinge turns about; where a shoulder points
    physics::Vec3 normal{0, 1, 0};  // world, square to the axis: where the angle is zero
    double swing = 0;               // cone_twist: rad, half angle
    double lower = 0, upper = 0;    // rad, of b against a about the axis
};

struct SceneDescription {
    std::vector<SceneBody> bodies;
    std::vector<SceneJoint> joints;
    std::optional<std::uint32_t> player;       // this body is driven in a circle
    std::optional<double> tunnelled_beyond_x;  // m: who ends there went through the wall
    int steps = 600;
    bool asleep_first = false;  // sleep is on, and the clock starts when all sleep
};

// Mass and principal inertia of a form of the scenes' density, about its own axes.
struct SolidMass {
    double mass = 0;        // kg
    physics::Vec3 inertia;  // kg m^2
};
SolidMass solid_mass(const Form& form);

// Where the player is driven before step k (from 0): only x and z count, the fall stays its own.
physics::Vec3 player_velocity(int step);

}  // namespace jostle::bench
