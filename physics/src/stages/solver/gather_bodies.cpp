// SPDX-License-Identifier: MIT
#include "physics/src/stages/solver/gather_bodies.h"

#include <array>
#include <cstdint>
#include <vector>

#include "jostle/base/check.h"
#include "physics/src/constraints/free_motion.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/solver/error_trial.h"
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
    return gyroscopic;
}

void put_mass(SolverBody& hot, const BodyCold& cold, const Mat3& inverse_inertia) {
    hot.inverse_mass = as_float(cold.inverse_mass);
    hot.inverse_spin = can_rotate(cold) ? as_float(cold.inverse_inertia.x.x) : 0;
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
    // gyroscopic bodies in each sub-step. Isotropic bodies and bodies with locked rotations have no
    // such change.
    const bool torque_alone = cold.isotropic || (cold.locks & all_rotations) != 0 || gyroscopic;
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

namespace {

constexpr std::uint8_t no_set = 255;
static_assert(solved_set_count < no_set);

// Lists the bodies of each colour set by ascending index, one set after the other.
template <class Takes>
void list_by_set(const std::vector<std::uint8_t>& set_of, BodiesBySet& list, Takes&& takes) {
    std::array<std::uint32_t, solved_set_count> next{};
    for (std::uint32_t i = 0; i < set_of.size(); i++) {
        ASSERT(set_of[i] == no_set || set_of[i] < solved_set_count);
        if (set_of[i] != no_set && takes(i)) next[set_of[i]]++;
    }
    std::uint32_t all = 0;
    for (std::size_t k = 0; k < next.size(); k++) {
        list.begin[k] = all;
        all += next[k];
        next[k] = list.begin[k];
    }
    list.begin.back() = all;
    list.all.resize(all);
    for (std::uint32_t i = 0; i < set_of.size(); i++)
        if (set_of[i] != no_set && takes(i)) list.all[next[set_of[i]]++] = i + 1;
}

void count_substeps(const StepContext& step, StepProfile& profile) {
    const SolverScratch& scratch = step.scratch.solver;
    for (std::size_t set = 0; set < solved_set_count; set++) {
        const auto bodies = static_cast<std::int64_t>(scratch.bodies.of(set, set + 1).size());
        const int substeps = step.contacts[set].substeps;
        profile.body_substeps += bodies * substeps;
        profile.contact_substeps += std::int64_t{step.world.graph.sets[set].contacts} * substeps;
        if (wants_trial(step, set)) profile.trial_substeps += bodies * (substeps / 2);
    }
    for (const std::uint32_t island : scratch.groups.active) {
        const Island& of = step.world.islands.islands[island];
        const int substeps = scratch.groups.of_island[island]->substeps;
        profile.body_substeps += std::int64_t{of.bodies} * substeps;
        if (wants_trial(step, index_of(of.colour_set)))
            profile.trial_substeps += std::int64_t{of.bodies} * (substeps / 2);
    }
}

void count_bodies(const BodyStore& bodies, const SolverScratch& scratch, StepProfile& profile) {
    profile.bodies_asleep_in_place = static_cast<int>(bodies.asleep_in_place);
    profile.bodies_awake = static_cast<int>(bodies.awake.size() - bodies.asleep_in_place);
    profile.bodies_in_solver = profile.bodies_awake - static_cast<int>(scratch.free.size());
    const auto bodies_of = [&](SolverTier tier) {
        const std::size_t first = index_of(ColourSetKey{tier, 0});
        return static_cast<int>(scratch.bodies.of(first, first + batch_count).size());
    };
    profile.bodies_flat = bodies_of(SolverTier::flat);
    profile.bodies_tall = bodies_of(SolverTier::tall);
    profile.bodies_heavy = bodies_of(SolverTier::heavy);
    profile.bodies_direct = bodies_of(SolverTier::direct);
}

}  // namespace

void gather_bodies(StepContext& step) {
    const BodyStore& bodies = step.world.bodies;
    const IslandStore& islands = step.world.islands;
    SolverScratch& scratch = step.scratch.solver;
    scratch.kinematic.clear();
    scratch.free.clear();
    scratch.set_of.assign(bodies.awake.size(), no_set);
    const auto cold_of = [&](std::uint32_t i) -> const BodyCold& {
        return bodies.cold[bodies.awake[i].body];
    };
    bool any_jointed = false;
    const bool grouped = !scratch.groups.active.empty();
    for (std::uint32_t i = 0; i < bodies.awake.size(); i++) {
        const BodyCold& cold = cold_of(i);
        const bool held = cold.constraints > 0 || cold.first_joint != none;
        if (cold.asleep_in_place) continue;
        if (grouped && scratch.groups.grouped[i] != 0) continue;
        if (cold.type == BodyType::kinematic) {
            // Its velocity moves it, regardless of contacts; the solver reads it if a body may
            // touch it.
            scratch.free.push_back(i);
            if (held || cold.first_edge != none) scratch.kinematic.push_back(i + 1);
        } else if (held) {
            ASSERT(islands.ids.alive(cold.island));
            const ColourSetKey set = islands.islands[cold.island].colour_set;
            scratch.set_of[i] = static_cast<std::uint8_t>(index_of(set));
            any_jointed = any_jointed || cold.first_joint != none;
        } else {
            scratch.free.push_back(i);
        }
    }
    list_by_set(scratch.set_of, scratch.bodies, [](std::uint32_t) { return true; });
    list_by_set(scratch.set_of, scratch.jointed,
                [&](std::uint32_t i) { return any_jointed && cold_of(i).first_joint != none; });
    ASSERT(scratch.jointed.all.size() <= scratch.bodies.all.size());
    // Each awake body is solved, free, in a joint group or asleep in place.
    ASSERT(grouped || scratch.bodies.all.size() + scratch.free.size() + bodies.asleep_in_place ==
                          bodies.awake.size());
}

void count_solver_work(StepContext& step) {
    count_bodies(step.world.bodies, step.scratch.solver, step.world.profile);
    count_substeps(step, step.world.profile);
}

}  // namespace jostle::physics
