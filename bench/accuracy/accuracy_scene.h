// SPDX-License-Identifier: MIT
//
// A scene of the laboratory in words that every engine shares. Engines build their worlds from it
// (accuracy_engine.h), experiments make it (experiment.h). SI units; z is up.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "jostle/physics/geometry.h"
#include "jostle/physics/transform.h"

namespace jostle::bench::accuracy {

using physics::Quat;
using physics::Transform;
using physics::Vec3;

// Corners of a convex solid, from its centre of mass and along its principal axes.
struct HullPoints {
    std::vector<Vec3> points;
};

// A plane is all that lies below; the normal is a unit vector. A cylinder lies along its y axis.
using Shape =
    std::variant<physics::Sphere, physics::Box, physics::Cylinder, physics::Plane, HullPoints>;

// How a body moves. A driven body keeps the velocity it is given, whatever it meets.
enum class Motion { free, fixed, kinematic };

struct Body {
    Motion motion = Motion::free;
    double mass = 1;             // kg
    Vec3 inertia{1, 1, 1};       // kg m^2 about the principal axes, which are the body's axes
    std::optional<Shape> shape;  // none: meets nothing
    Transform pose;              // of the centre of mass
    Vec3 velocity, spin;         // m/s and rad/s, world axes
};

enum class JointKind {
    ball,    // the anchors stay together
    hinge,   // and the bodies turn about the axis alone
    slider,  // b moves along the axis against a, and does not turn against it
    fixed,   // b moves with a
    rod,     // the distance of the two anchors stays what it is at the start
    spring,  // stiffness and damping along the line of the two anchors
};

struct Motor {
    double speed = 0;       // rad/s of b against a, about the axis
    double max_torque = 0;  // N m
};

// Of the hinge's angle: b against a, 0 at the start.
struct Limit {
    double lower = 0, upper = 0;  // rad
};

inline constexpr int ground = -1;  // the world itself as an end of a joint

// Anchors and axis are where they are at the start, in the world.
struct Joint {
    JointKind kind = JointKind::ball;
    int a = ground, b = 0;  // bodies of the scene
    Vec3 anchor;
    Vec3 anchor_b;  // of rods and springs: their end at b
    Vec3 axis{0, 1, 0};
    double stiffness = 0, damping = 0;  // of springs: N/m and N s/m
    double rest_length = 0;             // of springs: m
    std::optional<Vec3>
        misaligned_anchor_b;     // of balls: where their end at b is instead of the anchor
    std::optional<Motor> motor;  // of hinges
    std::optional<Limit> limit;  // of hinges
};

// Friction and restitution are those of each pair. An engine undoes its own rule of mixing.
struct Scene {
    std::string name;
    Vec3 gravity{0, 0, -9.81};
    double friction = 0, restitution = 0;
    std::vector<Body> bodies;
    std::vector<Joint> joints;
    // Pulls each body to the origin with mass * pull / r^2, N. 0: none.
    double central_pull = 0;
    // Any two bodies pull each other with mass * mass * mutual_pull / r^2, N. 0: none.
    double mutual_pull = 0;
    // Each body slows down by damping * velocity, 1/s, and its spin likewise.
    double damping = 0;
    bool continuous =
        false;  // fast bodies may pass through nothing: the engine's own way, if it has one
    bool planar = false;  // all motion is in the xz plane, and all joints' axes are along y
};

}  // namespace jostle::bench::accuracy
