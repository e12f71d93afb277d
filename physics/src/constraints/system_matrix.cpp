// SPDX-License-Identifier: MIT
#include "physics/src/constraints/system_matrix.h"

#include "jostle/base/check.h"

namespace jostle::physics {
namespace {

std::size_t body_index(int body) {
    ASSERT(body >= 0);
    return static_cast<std::size_t>(body);
}

struct UnitChange {
    Vec3 v, w;
};
// Change of a body's velocity from a unit impulse along the row.
UnitChange change_of(const RowJacobian& row_jacobian, const SystemBody& body) {
    return {scaled(row_jacobian.linear, body.inverse_mass),
            body.inverse_inertia * row_jacobian.angular};
}

// J M^-1 J^T: only rows that share a movable body are coupled.
void add_responses(ConstraintSystem& system) {
    const std::size_t count = system.rows.size();
    struct Use {
        std::size_t row;
        const RowJacobian* row_jacobian;
    };
    std::vector<std::vector<Use>> uses(system.bodies.size());
    for (std::size_t k = 0; k < count; k++)
        for (int p = 0; p < system.rows[k].jacobian_count; p++) {
            const RowJacobian& row_jacobian = system.rows[k].jacobians[p];
            ASSERT(body_index(row_jacobian.body) < system.bodies.size());
            if (system.bodies[body_index(row_jacobian.body)].moves)
                uses[body_index(row_jacobian.body)].push_back({k, &row_jacobian});
        }
    for (std::size_t body = 0; body < uses.size(); body++)
        for (const Use& from : uses[body]) {
            const UnitChange change = change_of(*from.row_jacobian, system.bodies[body]);
            for (const Use& to : uses[body])
                system.matrix[to.row * count + from.row] += dot(to.row_jacobian->linear, change.v) +
                                                            dot(to.row_jacobian->angular, change.w);
        }
    // The two triangles differ by rounding.
    for (std::size_t i = 0; i < count; i++)
        for (std::size_t j = 0; j < i; j++) {
            double &below = system.matrix[i * count + j], &above = system.matrix[j * count + i];
            below = above = 0.5 * (below + above);
        }
}

// Rows of a block are adjacent.
void add_softness(ConstraintSystem& system, std::size_t k) {
    const std::size_t count = system.rows.size();
    const ConstraintRow& row = system.rows[k];
    double* own = &system.matrix[k * count];
    if (row.softness == 0) return;
    ASSERT(row.softness > 0 && system.matrix.size() == count * count);
    if (row.block >= 0) {
        const double share = row.softness / own[k];
        ASSERT(own[k] > 0);
        for (std::size_t j = k; j-- > 0 && system.rows[j].block == row.block;)
            system.matrix[j * count + k] = own[j] += share * own[j];
    }
    own[k] += row.softness;
}

void add_vector(std::vector<double>& to, std::size_t first, Vec3 v) {
    to[first] += v.x;
    to[first + 1] += v.y;
    to[first + 2] += v.z;
}

const char* word_of_role(RowRole role) {
    switch (role) {
        case RowRole::point:
            return "point";
        case RowRole::rotation:
            return "rotation";
        case RowRole::distance:
            return "distance";
        case RowRole::limit:
            return "limit";
        case RowRole::spring:
            return "spring";
        case RowRole::motor:
            return "motor";
        case RowRole::friction:
            return "friction";
        case RowRole::velocity:
            return "velocity row";
        case RowRole::gear:
            return "gear";
        case RowRole::normal:
            return "normal";
        case RowRole::tangent:
            return "friction";
    }
    return "";
}

}  // namespace

double rate_now(const ConstraintRow& row, const std::vector<SystemBody>& bodies) {
    double rate = 0;
    for (int p = 0; p < row.jacobian_count; p++) {
        const SystemBody& body = bodies[body_index(row.jacobians[p].body)];
        rate += dot(row.jacobians[p].linear, body.linear_velocity) +
                dot(row.jacobians[p].angular, body.angular_velocity);
    }
    return rate;
}

double rate_by_forces(const ConstraintRow& row, const std::vector<SystemBody>& bodies) {
    double rate = 0;
    for (int p = 0; p < row.jacobian_count; p++) {
        const SystemBody& body = bodies[body_index(row.jacobians[p].body)];
        rate += dot(row.jacobians[p].linear, body.free_linear_velocity) +
                dot(row.jacobians[p].angular, body.free_angular_velocity);
    }
    return rate;
}

double response_of(const ConstraintRow& row, const std::vector<SystemBody>& bodies) {
    double response = 0;
    for (int p = 0; p < row.jacobian_count; p++) {
        const RowJacobian& row_jacobian = row.jacobians[p];
        const UnitChange change = change_of(row_jacobian, bodies[body_index(row_jacobian.body)]);
        response += dot(row_jacobian.linear, change.v) + dot(row_jacobian.angular, change.w);
    }
    return response;
}

void assemble(ConstraintSystem& system) {
    const std::size_t count = system.rows.size();
    system.matrix.assign(count * count, 0);
    system.rhs.resize(count);
    add_responses(system);
    for (std::size_t k = 0; k < count; k++) {
        const ConstraintRow& row = system.rows[k];
        add_softness(system, k);
        system.rhs[k] = row.bias - rate_by_forces(row, system.bodies);
    }
}

std::string name_of(const ConstraintRow& row) {
    std::string name = word_of_role(row.role);
    if (row.role == RowRole::normal || row.role == RowRole::tangent) {
        if (row.role == RowRole::tangent) name += row.axis == 0 ? " 1" : " 2";
        return name + " of point " + std::to_string(row.point);
    }
    constexpr const char* axes[] = {" x", " y", " z"};
    ASSERT(row.axis < 3);
    return row.axis < 0 ? name : name + axes[row.axis];
}

std::vector<double> ConstraintSystem::jacobian() const {
    const std::size_t columns = 6 * bodies.size();
    std::vector<double> dense(rows.size() * columns);
    for (std::size_t k = 0; k < rows.size(); k++)
        for (int p = 0; p < rows[k].jacobian_count; p++) {
            const RowJacobian& row_jacobian = rows[k].jacobians[p];
            const std::size_t first = k * columns + 6 * body_index(row_jacobian.body);
            add_vector(dense, first, row_jacobian.linear);
            add_vector(dense, first + 3, row_jacobian.angular);
        }
    return dense;
}

std::vector<double> ConstraintSystem::inverse_mass() const {
    const std::size_t columns = 6 * bodies.size();
    std::vector<double> dense(columns * columns);
    for (std::size_t k = 0; k < bodies.size(); k++) {
        const std::size_t first = 6 * k;
        const SystemBody& body = bodies[k];
        const double mass[] = {body.inverse_mass.x, body.inverse_mass.y, body.inverse_mass.z};
        for (std::size_t i = 0; i < 3; i++) {
            dense[(first + i) * columns + first + i] = mass[i];
        }
        // Symmetric: its columns are its rows.
        add_vector(dense, (first + 3) * columns + first + 3, body.inverse_inertia.x);
        add_vector(dense, (first + 4) * columns + first + 3, body.inverse_inertia.y);
        add_vector(dense, (first + 5) * columns + first + 3, body.inverse_inertia.z);
    }
    return dense;
}

int ConstraintSystem::moving_bodies() const {
    int count = 0;
    for (const SystemBody& body : bodies) count += body.moves ? 1 : 0;
    return count;
}

}  // namespace jostle::physics
