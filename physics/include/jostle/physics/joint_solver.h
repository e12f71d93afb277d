// SPDX-License-Identifier: MIT
//
// Selection of the joint solver: WorldDef::joint_solver for a world, JointDef::solver for one
// joint. The profile counts the joints of each solver: joints, joints_direct, joints_batched,
// joints_direct_fallback.
#pragma once

#include <cstdint>

namespace jostle::physics {

/// Solver of a joint group. A joint group consists of connected joints that are solved together.
///
/// A group uses the solver that its joints request. A joint's own setting takes precedence over the
/// world's; of several own settings, `direct` takes precedence over `iterative`, and `iterative`
/// over `automatic`.
///
/// Without contacts, a group is an island; bodies that touched recently count until the island is
/// split. With contacts, a group consists of bodies connected by ball, hinge, cone-twist and rigid
/// fixed joints.
enum class JointSolver : std::uint8_t {
    /// Direct where affordable, otherwise iterative.
    ///
    /// Without contacts: direct if the factorization takes at most 64 times the work of independent
    /// joints and the group has no cone-twist joints (ragdolls). With contacts: direct for the
    /// points of two or more joints, with the same limit. Nets (more than eight joints, and at
    /// least three joints per two bodies) are iterative, because they become nearly singular when
    /// they bend.
    automatic,
    /// Joints are solved one after the other in each sub-step, together with the contacts.
    /// Stiffness depends on the length of the sub-step; cost depends only on the number of joints.
    iterative,
    /// All joints of a group are solved at once by a factorization, including cone-twist joints and
    /// dense groups, up to a limit: in a world of n joints, a group of k joints may take 2e7 k / n
    /// multiplications per factorization (a net of 30 x 30 balls alone in its world), so all groups
    /// together never take more than 2e7.
    ///
    /// Falls back to `automatic`:
    /// - above this limit, and for nets of more than 2048 joints;
    /// - if a listener receives sub-steps, or a body has exactly one locked rotation;
    /// - for grabs, velocity rows, paths with kinks, driven orientations, springs with a maximum
    ///   force or torque, ball and cone-twist joints with friction, soft fixed joints, and ropes of
    ///   length zero;
    /// - with contacts, for everything except the points of ball, hinge, cone-twist and rigid fixed
    ///   joints.
    ///
    /// The setting does not affect how the continuous stage repairs joints that an impact
    /// separated.
    direct,
};

}  // namespace jostle::physics
