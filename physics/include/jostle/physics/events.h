// SPDX-License-Identifier: MIT
//
// What happened in the last step, and by calls between the step before and it. Arrays, to read
// until the next step. Sorted by the ids they name, so the order does not depend on threads. Code
// that is to run within a step: step_listener.h.
#pragma once

#include <span>

#include "jostle/physics/ids.h"
#include "jostle/physics/vec3.h"

namespace jostle::physics {

// Two shapes began to press on each other, or bounced: then they part with the next step.
struct ContactBegin {
    ShapeId shape_a, shape_b;
    BodyId body_a, body_b;
    Vec3 point;           // m, world: the middle of the contact points
    Vec3 normal;          // unit, from a to b
    double approach = 0;  // m/s at the start of the step, or at a bounce within it; >= 0
};

// They parted, or a call moved, changed or destroyed one of them. The id of what was destroyed is
// no longer valid.
struct ContactEnd {
    ShapeId shape_a, shape_b;
    BodyId body_a, body_b;
};

// They press on each other now, or met between sub-steps, and one of the shapes asked
// (ShapeDef::report_stays). One for each pair of shapes: of several manifolds and impacts impulses
// are summed, point and normal are those of the one that bears most.
struct ContactStay {
    ShapeId shape_a, shape_b;
    BodyId body_a, body_b;
    Vec3 point;   // m, world: the middle of the contact points
    Vec3 normal;  // unit, from a to b
    // N s over the step: that of the last sub-step times their number, and of impacts between them.
    double normal_impulse = 0;
    double friction_impulse = 0;
    double penetration = 0;  // m, of the deepest point; negative: apart
};

// They met at WorldDef::hit_speed or faster.
struct ContactHit {
    ShapeId shape_a, shape_b;
    BodyId body_a, body_b;
    Vec3 point;           // m, world
    Vec3 normal;          // unit, from a to b
    double approach = 0;  // m/s: at the start of the step, or at an impact within it
};

// A shape is in a trigger, came into it, or left it. It leaves when it is destroyed, too.
struct TriggerEvent {
    ShapeId trigger, shape;
    BodyId trigger_body, body;
};

// A joint's force or torque exceeded what it bears. The joint is gone; its id is no longer valid.
struct JointBreak {
    JointId joint;
    BodyId body_a, body_b;
    double force = 0, torque = 0;  // N, N m
};

struct Events {
    std::span<const ContactBegin> contacts_began;
    std::span<const ContactEnd> contacts_ended;
    std::span<const ContactStay> contacts;
    std::span<const ContactHit> hits;
    std::span<const TriggerEvent> triggers_entered, triggers_stayed, triggers_left;
    std::span<const JointBreak> joints_broke;
    std::span<const BodyId> fell_asleep;
    std::span<const BodyId> woke;
    // Bodies whose state was no longer finite, or was faster than 1e6 m/s or rad/s, or further than
    // 1e8 m from the origin. They are at rest where they were before the step.
    std::span<const BodyId> quarantined;
};

}  // namespace jostle::physics
