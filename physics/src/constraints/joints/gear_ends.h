// SPDX-License-Identifier: MIT
//
// Common form of gears, racks and pulleys: two ends, each with a displacement (an angle or a
// length) relative to a carrier, and one error of the combined displacements. In double;
// gear_kernel.h is the kernel for eight joints.
#pragma once

#include "physics/src/constraints/joints/joint_lane.h"
#include "physics/src/constraints/joints/joint_step.h"
#include "physics/src/state/joint_store.h"

namespace jostle::physics {

// The carrier of an end of a geared pair: a body, or the world.
struct Carrier {
    std::uint32_t body = 0xffffffff;  // body index; none: the world
    std::int32_t hot = 0;             // see JointEnd::hot
    Vec3 center, origin;              // centre of mass and origin of the body, m
    Quat rotation;
};

// Rotation of a body about its frame's z axis relative to the carrier, rad, -pi..pi. The reference
// angle is constant while the axis is fixed in the carrier.
double turn_against(Quat frame, Quat carrier);
// The angle nearest to `expected` that differs from `angle` by whole turns.
double unwrapped(double angle, double expected);
// Travel of a point along the axis relative to the carrier, from some reference point on the axis,
// m.
double travel_against(Vec3 point, Vec3 axis, const Carrier& carrier);

// A geared pair as one row. Its bodies are those of the ends a and b, then their carriers. Each
// body participates once.
struct GearTerms {
    struct End {
        bool turns = false;   // the displacement is an angle; otherwise a length
        double scale = 1;     // factor of its displacement in the sum
        Vec3 axis;            // world
        double travel = 0;    // rad or m
        double length = 0;    // m, of a rope
        double sign[4] = {};  // sign of each body's motion in the displacement
        Vec3 arm[4];          // m, of the end from each body's centre of mass
    };
    End ends[2];
    bool participates[4] = {};
    std::uint32_t body[4] = {};
    double sum = 0, target = 0;  // scaled sum of both displacements
};
GearTerms gear_terms(const Joint& joint, const JointEnd& a, const JointEnd& b,
                     const Carrier* carriers);

void write_gear(const Joint& joint, const JointEnd& a, const JointEnd& b, const Carrier* carriers,
                JointGearWide& to, const JointLane& lane);
void read_gear(Joint& joint, const JointGearWide& from, double dt, const JointLane& lane);

}  // namespace jostle::physics
