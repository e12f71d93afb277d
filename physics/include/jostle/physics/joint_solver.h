// SPDX-License-Identifier: MIT
//
// How joints are solved: WorldDef::joint_solver for all of a world's, JointDef::solver for one.
// How many were solved in which way says the profile: joints, joints_direct, joints_batched,
// joints_direct_fallback.
#pragma once

#include <cstdint>

namespace jostle::physics {

// What joints tie together is solved in one way, a joint group. Its solver is what its joints ask
// for: a joint's own wish goes before the world's, and of several own wishes `direct` before
// `iterative` before `automatic`. In the air a group is an island: bodies that touched lately count
// until it is split. Beside contacts it is what balls, hinges, cones and rigid fixed joints tie.
enum class JointSolver : std::uint8_t {
    // Directly where that is affordable: in the air at most 64 times the work of joints that know
    // nothing of each other, and no figures with cone-twists; beside contacts at most as much for
    // the points of two joints or more. Nets (more than eight joints, and three for two bodies) are
    // not: nearly singular as they bend. Else iteratively.
    automatic,
    // One joint after the other, sub-step by sub-step, with the contacts: as soft as the sub-step
    // is long, in time that only the number of joints decides. Nothing is solved directly.
    iterative,
    // All joints of a group at once, by a factorisation, with cone-twists and however dense, up to
    // a ceiling: where the world has n joints a group of k may take 2e7 k / n multiplications for
    // each factorisation (a net of 30 x 30 balls alone in its world), so that all of them together
    // take no more. Falls back to `automatic`
    //   above that ceiling, and for nets of more than 2048 joints;
    //   where a listener of sub-steps is there, or a body has exactly one locked turn;
    //   for gears, racks, pulleys, paths, grabs and velocity rows, orientations that are driven,
    //   springs with a greatest force or torque, balls and cone-twists that rub, springy fixed
    //   joints and ropes of no length;
    //   beside contacts, for all but the points of balls, hinges, cone-twists and rigid fixed
    //   joints.
    // What the continuous stage does to joints that an impact parted is not asked.
    direct,
};

}  // namespace jostle::physics
