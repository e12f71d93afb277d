// SPDX-License-Identifier: MIT
//
// The linear system that a step solves, as plain data: the rows of all joints and contacts of a
// connected group of bodies, their Jacobian, and the equation for their impulses,
//     (J M^-1 J^T + softness) impulses = bias - J (velocities after forces alone).
// World::constraint_system() builds it, for inspection, for another solver, or to examine its
// conditioning. Building it does not change the world.
//
// Springs are integrated implicitly (Catto, "Soft Constraints", GDC 2011): a softness added to J
// M^-1 J^T and a share of the error in the bias. Friction acts per point and direction: two rows
// per normal row, each bounded by friction times the impulse of the normal row. Limits of a
// three-component vector (the torque of a drive or of ball joint friction, the force of a grab)
// bound each component separately. The system does not contain restitution, rolling friction, or
// the mean impulses that the solver stores for contacts.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "jostle/physics/ids.h"
#include "jostle/physics/mat3.h"

namespace jostle::physics {

/// Maximum number of rows of a constraint system.
inline constexpr int constraint_rows_max = 1500;

/// Options of World::constraint_system().
struct ConstraintSystemOptions {
    /// Time over which the impulses act, in s, 1e-6 to 0.25. 0 selects one sub-step of the body's
    /// island; before the first step, of a step of 1/60 s.
    double h = 0;
    /// If true, forces act during h: gravity, force fields, applied forces, gyroscopic torques and
    /// damping. If false, the right-hand side uses the current velocities.
    bool forces = true;
    /// Fraction of each position error that is corrected within h, 0 to 1 (Baumgarte). 0 solves
    /// velocities only, so the impulses are those required by forces and velocities.
    double position_correction = 0;
    /// If true, rigid rows get the softness that the iterative solver uses, and errors are
    /// corrected at its rate instead of position_correction. If false, they are rigid.
    bool solver_softness = false;
};

/// The purpose of a constraint row.
enum class RowRole : std::uint8_t {
    point,     ///< constrains a point along an axis
    rotation,  ///< constrains the rotation about an axis
    distance,  ///< constrains a distance, as a rod
    limit,     ///< limit of an angle or a length
    spring,    ///< spring of a joint
    motor,     ///< motor of a joint
    friction,  ///< friction of a joint
    velocity,  ///< row of a VelocityRow
    gear,      ///< row of a gear, a rack or a pulley
    normal,    ///< normal of a contact point
    tangent,   ///< friction at a contact point
};

/// The part of a row that belongs to one body. The rate of the row is the sum of linear . v +
/// angular . w over its bodies. An impulse along the row acts along `linear` and about `angular`.
struct RowJacobian {
    int body = -1;         ///< index in ConstraintSystem::bodies
    Vec3 linear, angular;  ///< v is the velocity of the centre of mass
};

/// One scalar constraint.
struct ConstraintRow {
    RowRole role = RowRole::point;  ///< purpose of the row
    /// Axis of the row: 0, 1, 2 for x, y, z. World axes for the points of ball, hinge, fixed and
    /// grab joints; axes of a's frame for rotations and sliding axes; 0 or 1 for tangents. -1 if
    /// the row has only one direction.
    int axis = -1;
    JointId joint;             ///< of a joint row; otherwise null
    ShapeId shape_a, shape_b;  ///< of a contact row; otherwise null
    int point = 0;             ///< index of the contact point
    /// The parts of the row; the first jacobian_count are valid.
    RowJacobian jacobians[4];
    int jacobian_count = 0;

    /// Bounds of the impulse, in N s or N m s. For contact friction these are the current bounds;
    /// they follow the normal impulse: -friction * impulse of normal_row to friction * impulse of
    /// normal_row.
    double lower = 0, upper = 0;
    int normal_row = -1;  ///< of contact friction: index of the normal row
    double friction = 0;  ///< of contact friction: coefficient

    /// m or rad; for limits and contacts the remaining distance, negative beyond the limit.
    double error = 0;
    double rate = 0;      ///< J v with the current velocities, m/s or rad/s
    double bias = 0;      ///< target rate, m/s or rad/s
    double softness = 0;  ///< rate per impulse
    /// Rows of one block form a spring in two or three directions. Their softness is their part of
    /// J M^-1 J^T, including the off-diagonal elements, times a common factor. -1 if the row is in
    /// no block.
    int block = -1;
};
/// Returns a readable name: "point x", "limit", "normal of point 2".
std::string name_of(const ConstraintRow& row);

/// A body of a constraint system.
struct SystemBody {
    BodyId id;             ///< the body
    bool moves = false;    ///< true for dynamic bodies; otherwise the inverse masses are zero
    Vec3 inverse_mass;     ///< 1/kg, along the world axes; zero along locked axes
    Mat3 inverse_inertia;  ///< 1/(kg m^2), world
    Vec3 linear_velocity, angular_velocity;  ///< current, m/s and rad/s
    /// After h under forces alone, m/s and rad/s.
    Vec3 free_linear_velocity, free_angular_velocity;
};

/// The constraint rows of a connected group of bodies and their linear system.
struct ConstraintSystem {
    double h = 0;                     ///< time over which the impulses act, s
    std::vector<SystemBody> bodies;   ///< sorted by id
    std::vector<ConstraintRow> rows;  ///< joints sorted by id, then contacts sorted by shapes
    /// J M^-1 J^T + softness, rows x rows, row-major; symmetric, positive semi-definite.
    std::vector<double> matrix;
    std::vector<double> rhs;  ///< right-hand side, one entry per row

    /// Returns an element of `matrix`.
    double at(std::size_t row, std::size_t column) const {
        return matrix[row * rows.size() + column];
    }
    /// Returns J as a dense row-major matrix of rows x 6 bodies. Each body has the columns linear
    /// x, y, z and angular x, y, z.
    std::vector<double> jacobian() const;
    /// Returns M^-1 as a dense row-major matrix of 6 bodies x 6 bodies, in the same column order.
    std::vector<double> inverse_mass() const;
    /// Returns the number of dynamic bodies.
    int moving_bodies() const;
};

}  // namespace jostle::physics
