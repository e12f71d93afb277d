// SPDX-License-Identifier: MIT
//
// Transfers the values of one joint to and from its lane in a block. Used only when joints are
// written or read.
#pragma once

#include "jostle/base/check.h"
#include "jostle/physics/joint_defs.h"
#include "physics/src/constraint_graph/joint_constraint_wide.h"
#include "physics/src/constraint_graph/wide_rows.h"
#include "physics/src/constraints/softness.h"

namespace jostle::physics {

inline constexpr float never = 1e30f;  // a limit that is never reached

struct JointLane {
    int at;

    void put(float (&row)[8], double x) const { row[at] = as_float(x); }
    void put(float (*rows)[8], Vec3 v) const {
        put(rows[0], v.x), put(rows[1], v.y), put(rows[2], v.z);
    }
    void put(float (*rows)[8], Quat q) const {
        put(rows[0], q.x), put(rows[1], q.y), put(rows[2], q.z), put(rows[3], q.w);
    }
    void put(SoftRow& row, const Softness& s) const {
        put(row.position_rate, s.position_rate);
        put(row.velocity_scale, s.velocity_scale);
        put(row.impulse_scale, s.impulse_scale);
        put(row.once, s.once ? 1 : 0);
    }
    double get(const float (&row)[8]) const { return double{row[at]}; }
    Vec3 get3(const float (*rows)[8]) const { return {get(rows[0]), get(rows[1]), get(rows[2])}; }

    void put_limit(JointAngularWide& t, double lower, double upper) const {
        put(t.lower_at, lower);
        put(t.upper_at, upper);
    }
};

// Removes the remaining impulse and adds none.
inline constexpr Softness switched_off{0, 1e-30, 1};
// The kernels replace this with the maximum stiffness of the sub-step.
inline constexpr Softness as_stiff_as_can_be{0, 0, 0};

inline Softness spring_or(const JointSpring& spring, double h, const Softness& other) {
    return spring.hertz > 0 ? physics::spring(spring.hertz, spring.damping_ratio, h) : other;
}

inline Softness held_spring_or(const JointSpring& spring, double h, const Softness& other) {
    return spring.hertz > 0 ? held_spring(spring.hertz, spring.damping_ratio, h) : other;
}

// Maximum impulse of a spring in a sub-step, N s or N m s.
inline double strongest(double most, double h) {
    ASSERT(most >= 0 && h > 0);
    return most > 0 ? most * h : double{never};
}

// A disabled row stores no impulse.
inline double stored(bool enabled, double impulse) {
    return enabled ? impulse : 0;
}

}  // namespace jostle::physics
