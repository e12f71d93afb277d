// SPDX-License-Identifier: MIT
//
// Gears, racks and pulleys as what they have in common: two ends with a way each, a turn or a
// length, against a carrier, and one number that says how far both ways are from where they should
// be together. In double; the kernel for eight at a time is gear_kernel.h.
#pragma once

#include "physics/src/constraints/joints/joint_end.h"
#include "physics/src/constraints/joints/joint_lane.h"
#include "physics/src/state/joint_store.h"

namespace jostle::physics {

// What carries an end of a couple: a body, or the world.
struct Carrier {
    std::uint32_t body = 0xffffffff;  // index; none: the world
    std::int32_t hot = 0;             // as JointEnd's
    Vec3 center, origin;              // of mass; of the body, m
    Quat rotation;
};

// How far a body has turned about its frame's z axis against the carrier, rad, -pi..pi, from some
// angle that does not change as long as the axis keeps its place in the carrier.
double turn_against(Quat frame, Quat carrier);
// How far a point has gone along the axis against the carrier, from some point on it, m.
double travel_against(Vec3 point, Vec3 axis, const Carrier& carrier);

// A couple as one row. Its bodies: those of the ends a and b, then their carriers; one that is
// there already takes part once.
struct GearTerms {
    struct End {
        bool turns = false;   // the way is an angle; else a length
        double scale = 1;     // of its way in the sum
        Vec3 axis;            // world
        double travel = 0;    // rad or m
        double length = 0;    // m, of a rope
        double sign[4] = {};  // how its way changes with each body's
        Vec3 arm[4];          // m, of the end from each body's centre of mass
    };
    End ends[2];
    bool participates[4] = {};
    std::uint32_t body[4] = {};
    double sum = 0, target = 0;  // of both ways, by their scales
};
GearTerms gear_terms(const Joint& joint, const JointEnd& a, const JointEnd& b,
                     const Carrier* carriers);

void write_gear(const Joint& joint, const JointEnd& a, const JointEnd& b, const Carrier* carriers,
                JointGearWide& to, const JointLane& lane);
void read_gear(Joint& joint, const JointGearWide& from, double dt, const JointLane& lane);

}  // namespace jostle::physics
