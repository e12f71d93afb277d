// SPDX-License-Identifier: MIT
//
// Bodies. A body is three records: cold (what the user set and what links to it; at a fixed place),
// warm (pose and velocity in double; in the array of its set) and hot (what the contact kernel
// touches, made anew each step; in constraints/solver_body.h). Sets are contiguous, so the awake
// set is all that a step walks.
#pragma once

#include <cstdint>
#include <vector>

#include "jostle/physics/defs.h"
#include "jostle/physics/mat3.h"
#include "physics/src/foundation/flat_array.h"
#include "physics/src/foundation/id_pool.h"

namespace jostle::physics {

inline constexpr std::uint32_t none = 0xffffffff;

enum class BodySet : std::uint8_t {
    static_set,  // BodyStore::statics
    awake,       // BodyStore::awake: dynamic bodies that move or sleep in place, all kinematic ones
    sleeping,    // Island::sleepers of its island
};

struct BodyCold {
    // What the user set.
    BodyType type = BodyType::dynamic;
    bool sleep_allowed = true;
    bool continuous = true;
    AxisLocks locks = 0;
    double linear_damping = 0, angular_damping = 0, gravity_scale = 1;
    double mass_override = 0;  // kg; 0: what the shapes give
    std::uint64_t user_data = 0;

    // What its shapes make of it. Infinite mass and inertia are zero inverses.
    double mass = 0, inverse_mass = 0;
    Mat3 inertia = diagonal({0, 0, 0}),
         inverse_inertia = diagonal({0, 0, 0});  // about the centre, body axes
    Vec3 local_center;                           // of mass, from the body's origin
    double radius = 0;                           // m from the centre of mass to the furthest point
    double inner_radius = 0;                     // m: of its thinnest shape
    bool isotropic = true;  // inertia is a multiple of the identity: no gyroscopic term, no inertia
                            // to turn. Never of bodies with locks: those need the full matrix

    // Where it is and what hangs on it.
    BodySet set = BodySet::static_set;
    std::uint32_t at = 0;  // index in its set
    bool asleep_in_place =
        false;  // rests in an island that moves elsewhere (state/partial_sleep.h)
    std::uint32_t first_shape = none,
                  last_shape = none;   // list through ShapeRecord::next, in order of creation
    std::uint32_t first_edge = none;   // list of contacts: contact * 2 + side
    std::uint32_t first_joint = none;  // list of joints: joint * 2 + side
    std::uint32_t island = none;       // dynamic bodies always have one
    std::uint32_t island_prev = none, island_next = none;  // bodies in the island's list
    std::uint64_t colours = 0;      // of its contacts in the constraint graph
    std::uint32_t constraints = 0;  // contacts of it that are in the constraint graph
};

struct BodyWarm {
    std::uint32_t body = none;
    Vec3 center;  // of mass, m, world
    Quat rotation;
    Vec3 v, w;               // m/s, rad/s, world
    Vec3 force, torque;      // N, N m: for the next step, then zero
    double sleep_time = 0;   // s at rest
    Vec3 drift, drift_turn;  // m and rad, world, since then
    Mat3 axes;               // to_matrix(rotation): derived, not saved
};

// How far any point of a body can have moved since its creation, and can have moved when the next
// step is over. A pair that does not touch is looked at again only when the sum of both exceeds
// its limit. Indexed by body, apart from the rest because the scan over all separation bounds reads
// nothing else.
struct MotionBound {
    double travel = 0;  // m, never decreases
    double bound = 0;   // m
    double turned = 0;  // m: the part of `travel` that comes from turning
    // Until `travel`, the next step's included, reaches this, all shapes are within their fat
    // boxes. Derived: 0 means that nobody has checked.
    double fits_until = 0;  // m
};

struct BodyStore {
    IdPool ids;
    FlatArray<BodyCold> cold;       // by index
    FlatArray<MotionBound> motion;  // by index
    FlatArray<BodyWarm> statics, awake;
    std::uint32_t asleep_in_place = 0;  // how many of the awake set are; derived
};

inline Transform pose_of(const BodyWarm& warm, const BodyCold& cold) {
    return {warm.center - warm.axes * cold.local_center, warm.rotation};
}

// The inverses of its mass and inertia.
inline void invert_mass(BodyCold& cold) {
    cold.inverse_mass = cold.mass > 0 ? 1 / cold.mass : 0;
    const double spin = cold.inertia.x.x;
    if (!cold.isotropic)
        cold.inverse_inertia = inverse(cold.inertia);
    else
        cold.inverse_inertia =
            spin > 0 ? diagonal(Vec3{1, 1, 1} * (1 / spin)) : diagonal({0, 0, 0});
}

// A body whose axes are locked: what pushes it along or about one does nothing.
inline Vec3 free_directions(const BodyCold& cold) {
    return {(cold.locks & lock_x) != 0 ? 0.0 : 1.0, (cold.locks & lock_y) != 0 ? 0.0 : 1.0,
            (cold.locks & lock_z) != 0 ? 0.0 : 1.0};
}
inline Vec3 free_rotations(const BodyCold& cold) {
    return {(cold.locks & lock_rotation_x) != 0 ? 0.0 : 1.0,
            (cold.locks & lock_rotation_y) != 0 ? 0.0 : 1.0,
            (cold.locks & lock_rotation_z) != 0 ? 0.0 : 1.0};
}

// Inverse inertia in world axes. With locked turns: the inverse of what is left of the inertia when
// the locked rows and columns are taken out, not a part of the full inverse.
inline Mat3 world_inverse_inertia(const BodyWarm& warm, const BodyCold& cold) {
    constexpr AxisLocks turns = lock_rotation_x | lock_rotation_y | lock_rotation_z;
    if ((cold.locks & turns) == 0) {
        if (cold.isotropic) return cold.inverse_inertia;
        return warm.axes * cold.inverse_inertia * transpose(warm.axes);
    }
    if ((cold.locks & turns) == turns || cold.inverse_mass == 0) return diagonal({0, 0, 0});
    const Vec3 free = free_rotations(cold);
    Mat3 left = warm.axes * cold.inertia * transpose(warm.axes);
    left = {scaled(left.x, free) * free.x, scaled(left.y, free) * free.y,
            scaled(left.z, free) * free.z};
    const Mat3 inverted = inverse(left + diagonal(Vec3{1, 1, 1} - free));
    return {scaled(inverted.x, free) * free.x, scaled(inverted.y, free) * free.y,
            scaled(inverted.z, free) * free.z};
}

}  // namespace jostle::physics
