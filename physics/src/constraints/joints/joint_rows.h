// SPDX-License-Identifier: MIT
//
// The constraints, drives and limits of a joint as rows in double, for every kind and with the
// definitions of the kernels (joint_kinds.h, axes_kernel.h, gear_kernel.h). For inspection; the
// solver does not use these rows.
//
// A row's rate is the sum of linear . v + angular . w over its parts, where v is the velocity of
// the centre of mass.
#pragma once

#include <vector>

#include "jostle/physics/constraint_system.h"
#include "physics/src/constraints/joints/gear_ends.h"

namespace jostle::physics {

struct JointRowJacobian {
    std::uint32_t body = none;  // body index; none: the world
    Vec3 linear, angular;
};

struct JointRow {
    RowRole role = RowRole::point;
    int axis = -1;
    JointRowJacobian jacobians[4];
    int jacobian_count = 0;
    double error = 0;        // m or rad; for a one-sided row, the distance to the limit
    bool one_sided = false;  // pushes only along the row, and only at the limit
    double speed = 0;        // target of a motor or a velocity row
    double lower = -1e300, upper = 1e300;  // of the force, N or N m
    JointSpring spring;                    // 0 hertz: no spring
    double damper = 0;                     // 1/s; 0: no damper
    double compliance = 0;                 // rate per force
    int block = -1;                        // see ConstraintRow::block, counted within the joint

    bool rigid() const { return spring.hertz == 0 && damper == 0 && compliance == 0; }
    // Whether the row has a position error to correct.
    bool holds() const {
        return role != RowRole::motor && role != RowRole::friction && role != RowRole::velocity;
    }
};

// `carriers`: carriers of a gear or a rack; other kinds do not read them.
std::vector<JointRow> joint_rows(const Joint& joint, const JointEnd& a, const JointEnd& b,
                                 const Carrier* carriers);

}  // namespace jostle::physics
