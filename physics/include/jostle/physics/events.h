// SPDX-License-Identifier: MIT
//
// What happened in the last step, as arrays to read until the next one. Sorted by the ids they
// name, so the order does not depend on threads. No user code runs inside a step.
#pragma once

#include <span>

#include "jostle/physics/ids.h"
#include "jostle/physics/vec3.h"

namespace jostle::physics {

// Two shapes began to press on each other.
struct ContactBegin {
    ShapeId shape_a, shape_b;
    BodyId body_a, body_b;
    Vec3 point;           // m, world
    Vec3 normal;          // unit, from a to b
    double approach = 0;  // m/s at the start of the step, >= 0
};

// They parted, or one of them was destroyed (its id is then no longer valid).
struct ContactEnd {
    ShapeId shape_a, shape_b;
    BodyId body_a, body_b;
};

// They press on each other now, and one of the shapes asked (ShapeDef::report_stays).
struct ContactStay {
    ShapeId shape_a, shape_b;
    BodyId body_a, body_b;
    Vec3 point;                   // m, world: the middle of the contact points
    Vec3 normal;                  // unit, from a to b
    double normal_impulse = 0;    // N s over the step
    double friction_impulse = 0;  // N s over the step
    double penetration = 0;       // m, deepest point; negative: apart
};

// They met faster than WorldDef::hit_speed.
struct ContactHit {
    ShapeId shape_a, shape_b;
    BodyId body_a, body_b;
    Vec3 point;           // m, world
    Vec3 normal;          // unit, from a to b
    double approach = 0;  // m/s
};

// A shape came into a trigger, is in it, or left it (or was destroyed).
struct TriggerEvent {
    ShapeId trigger, shape;
    BodyId trigger_body, body;
};

// A joint's force or torque exceeded what it bears. It is gone; its id is no longer valid.
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
    // Bodies whose state stopped being a number: they were put back to their last good pose, at
    // rest.
    std::span<const BodyId> quarantined;
};

}  // namespace jostle::physics
