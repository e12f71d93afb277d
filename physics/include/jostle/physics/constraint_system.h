// SPDX-License-Identifier: MIT
//
// What a step has to solve, as plain data: the rows of all joints and contacts that hang together,
// their Jacobian, and the linear system of their impulses,
//     (J M^-1 J^T + softness) impulses = bias - J (velocities as forces alone would make them).
// World::constraint_system() makes one, for whoever wants to see it, solve it in another way, or
// know why it is hard. Asking changes nothing.
//
// Springs are implicit Euler's (Catto, "Soft Constraints", GDC 2011): a softness beside J M^-1 J^T
// and a share of the error in the bias. Friction is by the point and the direction: two rows beside
// each normal, each within friction times the normal's impulse. What limits a vector of three (the
// torque of a drive or of a ball's friction, a hand's force) bounds each component. Not there:
// bounces, resistance to rolling, and the means that the solver remembers of contacts.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "jostle/physics/ids.h"
#include "jostle/physics/mat3.h"

namespace jostle::physics {

inline constexpr int constraint_rows_max = 1500;

struct ConstraintSystemOptions {
    // s, 1e-6 to 0.25, over which the impulses act; 0: a sub-step, as the body's island takes them
    // (of a step of 1/60 s before the first).
    double h = 0;
    // Whether forces act for h: gravity, fields, the user's, those of uneven inertias, damping. If
    // not, the right-hand side is that of the velocities of now.
    bool forces = true;
    // The share of each error of position that is to be gone after h, 0..1 (Baumgarte). 0:
    // velocities alone, so that impulses are what forces and velocities need.
    double position_correction = 0;
    // true: what is rigid is as soft as the sweeps of the solver make it, which mends errors at
    // their rate instead of the above. false: rigid.
    bool solver_softness = false;
};

enum class RowRole : std::uint8_t {
    point,     // holds a point, along an axis
    turn,      // holds a direction, about an axis
    distance,  // a rod
    limit,     // of an angle or a length
    spring,
    motor,
    friction,  // of a joint
    velocity,  // of a VelocityRow
    gear,      // of a gear, a rack or a pulley
    normal,    // of a point of contact
    tangent,   // friction there
};

// What a row has to do with one body: the row's rate is the sum of linear . v + angular . w, and an
// impulse along it pushes along linear and turns about angular.
struct RowJacobian {
    int body = -1;         // of ConstraintSystem::bodies
    Vec3 linear, angular;  // v is that of the centre of mass
};

struct ConstraintRow {
    RowRole role = RowRole::point;
    // x, y, z are 0, 1, 2: of the world for points of balls, hinges, fixed joints and grabs; of a's
    // frame for turns and for what slides. A tangent's is 0 or 1. -1: there is but one direction.
    int axis = -1;
    JointId joint;             // of a joint's row
    ShapeId shape_a, shape_b;  // of a contact's
    int point = 0;             // which of its points
    RowJacobian jacobians[4];
    int jacobian_count = 0;

    // N s or N m s. Of friction at contacts they are those of now, which the normal's impulse
    // moves: -friction * impulse of normal_row .. friction * that.
    double lower = 0, upper = 0;
    int normal_row = -1;
    double friction = 0;

    double error = 0;     // m or rad; of limits and contacts what is left, negative: beyond
    double rate = 0;      // J v, with the velocities of now, m/s or rad/s
    double bias = 0;      // the rate that is wanted
    double softness = 0;  // rate per impulse
    // Rows of one block are a spring of two or three directions: softness is their part of J M^-1
    // J^T times one share, off the diagonal, too. -1: a row by itself.
    int block = -1;
};
std::string name_of(const ConstraintRow& row);  // "point x", "limit", "normal of point 2"

struct SystemBody {
    BodyId id;
    bool moves = false;             // dynamic; else the inverse masses are zero
    Vec3 inverse_mass;              // 1/kg, along the world's axes: zero along locked ones
    Mat3 inverse_inertia;           // 1/(kg m^2), world
    Vec3 velocity, spin;            // m/s, rad/s, now
    Vec3 free_velocity, free_spin;  // as the forces alone would have them after h
};

struct ConstraintSystem {
    double h = 0;                     // s
    std::vector<SystemBody> bodies;   // by id
    std::vector<ConstraintRow> rows;  // joints by id, then contacts by shapes
    // rows x rows, row by row; symmetric, positive semi-definite.
    std::vector<double> matrix;
    std::vector<double> rhs;  // one a row

    double at(std::size_t row, std::size_t column) const {
        return matrix[row * rows.size() + column];
    }
    // Dense, row by row. rows x 6 bodies: linear x y z, then angular x y z of each body.
    std::vector<double> jacobian() const;
    // 6 bodies x 6 bodies, in the same order.
    std::vector<double> inverse_mass() const;
    int moving_bodies() const;
};

}  // namespace jostle::physics
