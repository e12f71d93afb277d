// SPDX-License-Identifier: MIT
//
// Events of the last step, including those caused by calls between the previous step and it. To run
// code during a step, use a StepListener (step_listener.h).
#pragma once

#include <span>

#include "jostle/physics/ids.h"
#include "jostle/physics/vec3.h"

namespace jostle::physics {

/// Two shapes started to touch. Also reported for a bounce within a step; the shapes then separate
/// in the next step.
struct ContactBegin {
    ShapeId shape_a, shape_b;   ///< the shapes; normal points from a to b
    BodyId body_a, body_b;      ///< their bodies
    Vec3 point;                 ///< m, world, mean of the contact points
    Vec3 normal;                ///< unit vector from a to b
    double approach_speed = 0;  ///< m/s, at the start of the step or at a bounce within it; >= 0
};

/// Two shapes stopped touching, or a call moved, changed or destroyed one of them. The ids of
/// destroyed objects are no longer valid.
struct ContactEnd {
    ShapeId shape_a, shape_b;  ///< the shapes
    BodyId body_a, body_b;     ///< their bodies
};

/// Two shapes that touch, or that collided between sub-steps, at least one of which has
/// ShapeDef::report_stays set. One entry per pair of shapes: the impulses of all its manifolds and
/// impacts are summed; point and normal are those of the manifold with the largest impulse.
struct ContactStay {
    ShapeId shape_a, shape_b;  ///< the shapes; normal points from a to b
    BodyId body_a, body_b;     ///< their bodies
    Vec3 point;                ///< m, world, mean of the contact points
    Vec3 normal;               ///< unit vector from a to b
    /// Impulse along the normal over the step, in N s: that of the last sub-step times the number
    /// of sub-steps, plus the impulses of impacts between sub-steps.
    double normal_impulse = 0;
    double friction_impulse = 0;  ///< N s over the step, tangential
    double penetration = 0;       ///< m, of the deepest point; negative if the shapes are separated
};

/// Two shapes that collided at WorldDef::hit_speed or faster.
struct ContactHit {
    ShapeId shape_a, shape_b;   ///< the shapes; normal points from a to b
    BodyId body_a, body_b;      ///< their bodies
    Vec3 point;                 ///< m, world
    Vec3 normal;                ///< unit vector from a to b
    double approach_speed = 0;  ///< m/s, at the start of the step or at an impact within it
};

/// A shape that is inside a trigger, entered it, or left it. Destroying the shape or the trigger
/// counts as leaving. A shape that passes through within a step both entered and left in that step.
struct TriggerEvent {
    ShapeId trigger, shape;     ///< the trigger and the shape inside it
    BodyId trigger_body, body;  ///< their bodies
};

/// A joint whose force or torque exceeded JointDef::break_force or break_torque. The joint has been
/// destroyed; its id is no longer valid.
struct JointBreak {
    JointId joint;                 ///< the destroyed joint
    BodyId body_a, body_b;         ///< the bodies that it connected
    double force = 0, torque = 0;  ///< N, N m
};

/// The events of the last step (World::events). The spans are valid until the next step or restore.
/// Entries are sorted by the ids they name, so their order does not depend on the number of
/// threads.
struct Events {
    std::span<const ContactBegin> contacts_began;  ///< pairs of shapes that started to touch
    std::span<const ContactEnd> contacts_ended;    ///< pairs of shapes that stopped touching
    std::span<const ContactStay> contacts;         ///< pairs with ShapeDef::report_stays that touch
    std::span<const ContactHit> hits;  ///< contacts that began at WorldDef::hit_speed or faster
    /// Shapes that entered, stayed in and left triggers.
    std::span<const TriggerEvent> triggers_entered, triggers_stayed, triggers_left;
    std::span<const JointBreak> joints_broke;  ///< joints that exceeded their limits
    std::span<const BodyId> fell_asleep;       ///< bodies that fell asleep
    std::span<const BodyId> woke;              ///< bodies that woke
    /// Bodies whose state became non-finite, faster than 1e6 m/s or 1e6 rad/s, or farther than 1e8
    /// m from the origin. The step resets them to their pose before the step, at rest.
    std::span<const BodyId> quarantined;
};

}  // namespace jostle::physics
