// SPDX-License-Identifier: MIT
//
// Bodies. A body consists of three records: cold (user settings and links; at a fixed index), warm
// (pose and velocity in double precision; in the array of its set) and hot (input of the contact
// kernel, rebuilt in each step; constraint_graph/solver_body.h). Sets are contiguous, so a step
// iterates only over the awake set.
#pragma once

#include <cstdint>
#include <vector>

#include "jostle/base/check.h"
#include "jostle/physics/defs.h"
#include "jostle/physics/ids.h"
#include "jostle/physics/mat3.h"
#include "physics/src/foundation/flat_array.h"
#include "physics/src/foundation/id_pool.h"
#include "physics/src/math/principal_axes.h"

namespace jostle::physics {

inline constexpr std::uint32_t none = 0xffffffff;

enum class BodySet : std::uint8_t {
    static_set,  // BodyStore::statics
    // BodyStore::awake: dynamic bodies that are awake or sleep in place, all kinematic bodies.
    awake,
    sleeping,  // Island::sleepers of its island
};

struct BodyCold {
    // User settings.
    BodyType type = BodyType::dynamic;
    bool sleep_allowed = true;
    bool continuous = true;
    AxisLocks locks = 0;
    double linear_damping = 0, angular_damping = 0, gravity_scale = 1;
    double mass_override = 0;  // kg; 0: the mass of the shapes
    std::uint64_t user_data = 0;

    // Derived from the shapes. Infinite mass and inertia have zero inverses.
    double mass = 0, inverse_mass = 0;
    Mat3 inertia = diagonal({0, 0, 0}),
         inverse_inertia = diagonal({0, 0, 0});  // about the centre of mass, body axes
    Vec3 local_center;                           // centre of mass relative to the body's origin
    double radius = 0;        // distance of the furthest point from the centre of mass, m
    double inner_radius = 0;  // inner radius of its thinnest shape, m
    PrincipalAxes principal;  // of the inertia; derived, not saved
    // True if the inertia is a multiple of the identity, so that it has no gyroscopic term and need
    // not be rotated. Never true for bodies with locks, which need the full matrix.
    bool isotropic = true;

    // Location and links.
    BodySet set = BodySet::static_set;
    std::uint32_t at = 0;  // index in its set
    // Rests in an island of which other bodies move (state/partial_sleep.h).
    bool asleep_in_place = false;
    // List through ShapeRecord::next, in order of creation.
    std::uint32_t first_shape = none, last_shape = none;
    std::uint32_t first_edge = none;                       // list of contacts: contact * 2 + side
    std::uint32_t first_joint = none;                      // list of joints: joint * 2 + side
    std::uint32_t island = none;                           // every dynamic body has one
    std::uint32_t island_prev = none, island_next = none;  // list of the island's bodies
    std::uint64_t colours = 0;      // colours of its contacts in the constraint graph
    std::uint32_t constraints = 0;  // number of its contacts in the constraint graph
    std::uint32_t fixed_pairs = 0;  // of a dynamic body: pairs with bodies that are not; derived
};

struct BodyWarm {
    std::uint32_t body = none;
    Vec3 center;  // centre of mass, m, world
    Quat rotation;
    Vec3 v, w;               // m/s, rad/s, world
    Vec3 force, torque;      // N, N m: applied in the next step, then cleared
    double sleep_time = 0;   // time at rest, s
    Vec3 drift, drift_turn;  // displacement since the rest began, m and rad, world
    Mat3 axes;               // to_matrix(rotation); derived, not saved
};

// Upper bounds of the displacement of any point of a body since its creation: so far, and at the
// end of the next step. A pair that does not touch is tested again only when the sum of both
// exceeds its limit. Indexed by body, separate from the other records because the scan over all
// separation bounds reads nothing else.
struct MotionBound {
    double travel = 0;  // m, never decreases
    double bound = 0;   // m
    double turned = 0;  // part of `travel` that is caused by rotation, m
    // All shapes are inside their fat boxes until `travel`, including that of the next step,
    // reaches this value. Derived; 0 means not computed.
    double fits_until = 0;  // m
};

struct BodyStore {
    IdPool ids;
    FlatArray<BodyCold> cold;       // by index
    FlatArray<MotionBound> motion;  // by index
    FlatArray<BodyWarm> statics, awake;
    std::uint32_t asleep_in_place = 0;  // bodies of the awake set that sleep in place; derived
};

inline bool is_dynamic(const BodyStore& bodies, std::uint32_t body) {
    return body != none && bodies.cold[body].type == BodyType::dynamic;
}

inline BodyId body_id(const BodyStore& bodies, std::uint32_t body) {
    if (body == none) return {};
    return {body, bodies.ids.generation(body)};
}

inline Transform pose_of(const BodyWarm& warm, const BodyCold& cold) {
    return {warm.center - warm.axes * cold.local_center, warm.rotation};
}

// Computes the inverses of mass and inertia, and the principal axes.
inline void invert_mass(BodyCold& cold) {
    ASSERT(cold.mass >= 0);
    cold.inverse_mass = cold.mass > 0 ? 1 / cold.mass : 0;
    const double spin = cold.inertia.x.x;
    if (!cold.isotropic)
        cold.inverse_inertia = inverse(cold.inertia);
    else
        cold.inverse_inertia =
            spin > 0 ? diagonal(Vec3{1, 1, 1} * (1 / spin)) : diagonal({0, 0, 0});
    cold.principal = principal_axes(cold.inertia);
}

// 1 for free and 0 for locked axes. Impulses along or about locked axes have no effect.
inline Vec3 free_directions(const BodyCold& cold) {
    return {(cold.locks & lock_x) != 0 ? 0.0 : 1.0, (cold.locks & lock_y) != 0 ? 0.0 : 1.0,
            (cold.locks & lock_z) != 0 ? 0.0 : 1.0};
}
inline Vec3 free_rotations(const BodyCold& cold) {
    return {(cold.locks & lock_rotation_x) != 0 ? 0.0 : 1.0,
            (cold.locks & lock_rotation_y) != 0 ? 0.0 : 1.0,
            (cold.locks & lock_rotation_z) != 0 ? 0.0 : 1.0};
}

inline constexpr AxisLocks all_rotations = lock_rotation_x | lock_rotation_y | lock_rotation_z;
inline bool can_rotate(const BodyCold& cold) {
    return (cold.locks & all_rotations) != all_rotations;
}
// Returns whether contacts need a matrix for the inertia of a dynamic body.
inline bool needs_inertia_matrix(const BodyCold& cold) {
    return !cold.isotropic && can_rotate(cold);
}

// Inverse inertia in world axes. With locked rotations, it is the inverse of the inertia without
// the locked rows and columns, not a part of the full inverse.
inline Mat3 world_inverse_inertia(const BodyWarm& warm, const BodyCold& cold) {
    if ((cold.locks & all_rotations) == 0) {
        if (cold.isotropic) return cold.inverse_inertia;
        return warm.axes * cold.inverse_inertia * transpose(warm.axes);
    }
    if (!can_rotate(cold) || cold.inverse_mass == 0) return diagonal({0, 0, 0});
    const Vec3 free = free_rotations(cold);
    // One free axis: planar worlds and upright bodies.
    if (free.x + free.y + free.z == 1) {
        const Vec3 own = transposed_times(warm.axes, free);
        return diagonal(free * (1 / dot(own, cold.inertia * own)));
    }
    Mat3 remaining = warm.axes * cold.inertia * transpose(warm.axes);
    remaining = {scaled(remaining.x, free) * free.x, scaled(remaining.y, free) * free.y,
                 scaled(remaining.z, free) * free.z};
    const Mat3 inverted = inverse(remaining + diagonal(Vec3{1, 1, 1} - free));
    return {scaled(inverted.x, free) * free.x, scaled(inverted.y, free) * free.y,
            scaled(inverted.z, free) * free.z};
}

}  // namespace jostle::physics
