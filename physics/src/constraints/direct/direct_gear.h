// SPDX-License-Identifier: MIT
//
// A gear, rack or pulley (constraints/joints/gear_ends.h) of a group: one row over the bodies of
// its two ends and their carriers, in double. The error is the scaled sum of the displacements of
// both ends minus a target.
#pragma once

#include <cstdint>
#include <span>

#include "physics/src/constraints/direct/direct_body.h"

namespace jostle::physics {

struct DirectGear {
    enum class Motion : std::uint8_t { turn, slide, hang };
    // Constant but for the travel. Bodies are referenced by their number in the group.
    struct End {
        Motion motion = Motion::turn;
        double scale = 1;
        int body = 0, carrier = -1;  // carrier: -1 if it is the world
        Vec3 arm;                    // of the frame's origin, principal axes of the body
        Quat frame;                  // principal axes
        Quat carrier_axes;           // of the carrier's principal axes in its frame
        Vec3 carrier_center;         // m, of the carrier's centre of mass in its frame
        Vec3 point;                  // m, world: what a rope runs over
        double travel = 0;           // rad, counting turns, or m; at the state of write_gear()
    };
    End ends[2];
    double target = 0;

    // Each body once.
    struct Part {
        int body = 0;
        Vec3 linear, angular;
    };
    Part parts[4];
    int part_count = 0;
    double value = 0;  // scaled sum of the travels
};

// Call after the ends are set: lists the bodies.
void list_parts(DirectGear& gear);
// At the current state of the bodies. Follows the turns.
void write_gear(DirectGear& gear, std::span<const DirectBody> bodies);
// The rows of which the sum changes by exactly h J (v, w) if a Cayley map rotates the bodies.
void write_mean_gear(DirectGear& gear, std::span<const DirectBody> bodies);
void clear_parts(DirectGear& gear);  // to no effect
// The scaled sum at the end of the attempt.
double trial_sum(const DirectGear& gear, std::span<const DirectBody> bodies);
double rate_of(const DirectGear& gear, std::span<const DirectBody> bodies);
const DirectGear::Part& part_of(const DirectGear& gear, int body);

}  // namespace jostle::physics
