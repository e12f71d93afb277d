// SPDX-License-Identifier: MIT
//
// What a joint keeps, drives and limits, as rows in double: every kind, in the terms of the kernels
// (joint_kinds.h, axes_kernel.h, gear_kernel.h), for whoever wants to see them. The solver does
// not run by these.
//
// A row's rate is the sum of linear . v + angular . w over its parts, v that of the centre of mass.
#pragma once

#include <vector>

#include "jostle/physics/constraint_system.h"
#include "physics/src/constraints/joints/gear_ends.h"

namespace jostle::physics {

struct JointRowJacobian {
    std::uint32_t body = none;  // index; none: the world
    Vec3 linear, angular;
};

struct JointRow {
    RowRole role = RowRole::point;
    int axis = -1;
    JointRowJacobian jacobians[4];
    int jacobian_count = 0;
    double error = 0;                      // m or rad; of what is one-sided: what is left
    bool one_sided = false;                // pushes along the row alone, once nothing is left
    double speed = 0;                      // that a motor or a velocity row wants
    double lower = -1e300, upper = 1e300;  // of the force, N or N m
    JointSpring spring;                    // 0 hertz: none
    double damper = 0;                     // 1/s; 0: none
    double compliance = 0;                 // rate per force
    int block = -1;                        // as ConstraintRow's, counted in the joint

    bool rigid() const { return spring.hertz == 0 && damper == 0 && compliance == 0; }
    // What holds: an error of it is to be mended.
    bool holds() const {
        return role != RowRole::motor && role != RowRole::friction && role != RowRole::velocity;
    }
};

// `carriers` are those of a gear or a rack; others do not read them.
std::vector<JointRow> joint_rows(const Joint& joint, const JointEnd& a, const JointEnd& b,
                                 const Carrier* carriers);

}  // namespace jostle::physics
