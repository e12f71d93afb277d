// SPDX-License-Identifier: MIT
#include "physics/src/stages/solver/prepare_body.h"

#include <optional>

#include "jostle/base/check.h"
#include "physics/src/constraints/free_motion.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/step_scratch.h"

namespace jostle::physics {
namespace {

void put(float* row, Vec3 linear, Vec3 angular) {
    row[0] = as_float(linear.x), row[1] = as_float(linear.y), row[2] = as_float(linear.z);
    row[3] = as_float(angular.x), row[4] = as_float(angular.y), row[5] = as_float(angular.z);
}

// Chooses the axes of the body's spin. Returns whether it is gyroscopic.
bool prepare_spin(SolverScratch& scratch, const BodyWarm& warm, const BodyCold& cold, double dt,
                  std::uint32_t hot_index) {
    const bool touched = cold.constraints > 0;
    const bool gyroscopic = is_gyroscopic(
        warm, cold, dt, touched ? tuning::gyroscopic_turn : tuning::jointed_gyroscopic_turn);
    scratch.spin_axes[hot_index] = !gyroscopic ? SpinAxes::world
                                   : touched   ? SpinAxes::body
                                               : SpinAxes::world_by_substeps;
    if (!gyroscopic) return false;
    const std::optional<PrincipalRatios> bend = principal_ratios(cold);
    scratch.gyroscopic[hot_index] = {
        warm.axes,       warm.rotation, warm.rotation, {}, bend ? bend->factors : Vec3{},
        bend.has_value()};
    return true;
}

void put_mass(SolverBody& hot, const BodyCold& cold, const Mat3& inverse_inertia) {
    hot.inverse_mass = as_float(cold.inverse_mass);
    hot.inverse_spin = as_float(cold.inverse_inertia.x.x);
    put_inertia(hot, inverse_inertia);
    const Vec3 free = free_directions(cold);
    hot.free_x = as_float(free.x);
    hot.free_y = as_float(free.y);
    hot.free_z = as_float(free.z);
}

}  // namespace

void prepare_body(const StepContext& step, double h, std::uint32_t hot_index) {
    const WorldState& world = step.world;
    SolverScratch& scratch = step.scratch.solver;
    ASSERT(hot_index > 0 && hot_index < scratch.hot.size());
    SolverBody& hot = scratch.hot[hot_index];
    ExternalChange& external = scratch.external[hot_index];
    const BodyWarm& warm = world.bodies.awake[hot_index - 1];
    const BodyCold& cold = world.bodies.cold[warm.body];
    ASSERT(!cold.asleep_in_place);
    const bool gyroscopic = prepare_spin(scratch, warm, cold, step.dt, hot_index);
    hot = {};
    hot.spins_along = gyroscopic && cold.constraints > 0 && cold.first_joint != none ? 1 : 0;
    external = {};
    for (float& retained : external.retained) retained = 1;
    put(hot.v, warm.v, warm.w);
    if (cold.type == BodyType::kinematic) return;
    ASSERT(cold.type == BodyType::dynamic && h > 0);
    const Mat3 inverse_inertia = world_inverse_inertia(warm, cold);
    put_mass(hot, cold, inverse_inertia);
    const double linear = damping_factor(cold.linear_damping, h);
    const double angular = damping_factor(cold.angular_damping, h);
    ASSERT(linear >= 0 && linear <= 1 && angular >= 0 && angular <= 1);
    for (int k = 0; k < 3; k++) {
        external.retained[k] = as_float(linear);
        external.retained[k + 3] = as_float(angular);
    }
    // The gyroscopic spin change of a free step, distributed evenly over the sub-steps: it
    // conserves angular momentum as a free step does. integrate_gyroscopic() changes the spin of
    // gyroscopic bodies in each sub-step. Isotropic bodies have no such change.
    const bool torque_alone = (cold.isotropic && cold.locks == 0) || gyroscopic;
    const Vec3 spin_up = torque_alone ? inverse_inertia * warm.torque
                                      : (free_spin(warm, cold, step.dt).w - warm.w) / step.dt;
    put(external.push, acceleration_of(warm, cold, world.def.gravity) * h, spin_up * h);
}

void put_inertia(SolverBody& hot, const Mat3& inverse) {
    hot.inertia[0] = as_float(inverse.x.x);
    hot.inertia[1] = as_float(inverse.y.y);
    hot.inertia[2] = as_float(inverse.z.z);
    hot.inertia[3] = as_float(inverse.x.y);
    hot.inertia[4] = as_float(inverse.x.z);
    hot.inertia[5] = as_float(inverse.y.z);
}

}  // namespace jostle::physics
