// SPDX-License-Identifier: MIT
//
// An engine-independent scene of the accuracy benchmark. Experiments create it (experiment.h), and
// engines build their worlds from it (accuracy_engine.h). SI units; z points up.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "jostle/physics/geometry.h"
#include "jostle/physics/joint_defs.h"
#include "jostle/physics/transform.h"

namespace jostle::bench::accuracy {

using physics::Quat;
using physics::Transform;
using physics::Vec3;

// Corners of a convex solid, relative to its centre of mass and along its principal axes.
struct HullPoints {
    std::vector<Vec3> points;
};

// A shape that only Jostle's adapter supports, such as a mesh.
struct OtherShape {
    physics::Geometry geometry;
};

// A plane is solid below; its normal is a unit vector. Cylinders and capsules lie along their y
// axis.
using Shape = std::variant<physics::Sphere, physics::Box, physics::Cylinder, physics::Plane,
                           HullPoints, physics::Capsule, OtherShape>;

// How a body moves. A driven body keeps its prescribed velocity through collisions.
enum class Motion { free, fixed, kinematic };

struct Body {
    Motion motion = Motion::free;
    double mass = 1;             // kg
    Vec3 inertia{1, 1, 1};       // kg m^2 about the principal axes, which are the body's axes
    std::optional<Shape> shape;  // none: no collision
    Transform pose;              // of the centre of mass
    Vec3 velocity, spin;         // m/s and rad/s, world axes
    bool trigger = false;        // reports the bodies inside it, without contact forces
    bool rotation_locked = false;
};

enum class JointKind {
    ball,    // the anchors coincide
    hinge,   // likewise, and the bodies rotate only about the axis
    slider,  // b translates along the axis relative to a, without rotation
    fixed,   // b moves with a
    rod,     // the distance of the anchors is constant
    spring,  // stiffness and damping along the line of the anchors
};

struct Motor {
    double speed = 0;       // rad/s of b relative to a, about the axis
    double max_torque = 0;  // N m
};

// Limits of the hinge angle of b relative to a, 0 at the start.
struct Limit {
    double lower = 0, upper = 0;  // rad
};

// A joint that only Jostle's adapter supports. The frames are those of the two bodies.
struct OtherJoint {
    physics::JointKind kind;
    Transform frame_a, frame_b;
};

inline constexpr int ground = -1;  // the world as an end of a joint

// Anchors and axis are in world coordinates at the start.
struct Joint {
    JointKind kind = JointKind::ball;
    int a = ground, b = 0;  // bodies of the scene
    Vec3 anchor;
    Vec3 anchor_b;  // of rods and springs: the end at b
    Vec3 axis{0, 1, 0};
    double stiffness = 0, damping = 0;  // of springs: N/m and N s/m
    double rest_length = 0;             // of springs: m
    std::optional<Vec3>
        misaligned_anchor_b;          // of balls: the end at b, if it differs from the anchor
    std::optional<Motor> motor;       // of hinges
    std::optional<Limit> limit;       // of hinges
    std::optional<OtherJoint> other;  // replaces the kind, the anchors and the axis
};

// Friction and restitution are those of each pair. Engines compensate their own mixing rules.
struct Scene {
    std::string name;
    Vec3 gravity{0, 0, -9.81};
    double friction = 0, restitution = 0;
    std::vector<Body> bodies;
    std::vector<Joint> joints;
    // Attracts each body to the origin with mass * pull / r^2, N. 0: none.
    double central_pull = 0;
    // Any two bodies attract each other with mass * mass * mutual_pull / r^2, N. 0: none.
    double mutual_pull = 0;
    // Damping of the velocity and the spin of each body, 1/s.
    double damping = 0;
    bool continuous = false;  // continuous collision detection, if the engine has it
    bool planar = false;      // all motion is in the xz plane, and all joint axes are along y
    // A planar world of Jostle: spheres and boxes only, for which `planar` holds.
    bool planar_world = false;
};

}  // namespace jostle::bench::accuracy
