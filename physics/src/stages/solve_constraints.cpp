// SPDX-License-Identifier: MIT
#include "stages/solve_constraints.h"

#include "constraints/contact_passes.h"
#include "constraints/free_motion.h"
#include "stages/solve_joints.h"

namespace jostle::physics {
namespace {

float as_float(double x) {
    return static_cast<float>(x);
}

void put(float* row, Vec3 linear, Vec3 angular) {
    row[0] = as_float(linear.x), row[1] = as_float(linear.y), row[2] = as_float(linear.z);
    row[3] = as_float(angular.x), row[4] = as_float(angular.y), row[5] = as_float(angular.z);
}

void sort_out_bodies(WorldState& world) {
    StepScratch& scratch = world.scratch;
    scratch.in_solver.clear();
    scratch.free.clear();
    for (std::uint32_t i = 0; i < world.bodies.awake.size(); i++) {
        const BodyCold& cold = world.bodies.cold[world.bodies.awake[i].body];
        // Kinematic bodies fly free; the solver reads them when something may touch them.
        const bool held = cold.lanes > 0 || cold.first_joint != none;
        if (held || (cold.type == BodyType::kinematic && cold.first_edge != none))
            scratch.in_solver.push_back(i + 1);
        // Kinematic bodies are moved by their velocity, whatever touches them.
        if (!held || cold.type == BodyType::kinematic) scratch.free.push_back(i);
    }
    world.profile.bodies_awake = static_cast<int>(world.bodies.awake.size());
    world.profile.bodies_in_solver =
        static_cast<int>(world.bodies.awake.size() - scratch.free.size());
}

// The hot record and the drive of one body at the start of the step.
void prepare_body(const StepContext& step, std::uint32_t index, HotBody& hot, BodyDrive& drive) {
    const WorldState& world = step.world;
    const BodyWarm& warm = world.bodies.awake[index];
    const BodyCold& cold = world.bodies.cold[warm.body];
    hot = {};
    drive = {};
    for (float& keep : drive.keep) keep = 1;
    put(hot.v, warm.v, warm.w);
    if (cold.type == BodyType::kinematic) return;
    hot.inverse_mass = as_float(cold.inverse_mass);
    hot.inverse_spin = as_float(cold.inverse_inertia.x.x);
    const Mat3 inertia = world_inverse_inertia(warm, cold);
    hot.inertia[0] = as_float(inertia.x.x);
    hot.inertia[1] = as_float(inertia.y.y);
    hot.inertia[2] = as_float(inertia.z.z);
    hot.inertia[3] = as_float(inertia.x.y);
    hot.inertia[4] = as_float(inertia.x.z);
    hot.inertia[5] = as_float(inertia.y.z);

    const Vec3 free = free_directions(cold);
    hot.free_x = as_float(free.x);
    hot.free_y = as_float(free.y);
    hot.free_z = as_float(free.z);

    const double h = step.dt / step.contacts.substeps;
    const double linear = damping_factor(cold.linear_damping, h);
    const double angular = damping_factor(cold.angular_damping, h);
    for (int k = 0; k < 3; k++) {
        drive.keep[k] = as_float(linear);
        drive.keep[k + 3] = as_float(angular);
    }
    // The gyroscopic change of spin over the free step, spread evenly: it keeps L as the free step
    // does. Bodies that turn far in a step take it sub-step by sub-step: tumble(). Isotropic ones
    // have none.
    const bool torque_alone = (cold.isotropic && cold.locks == 0) || tumbles(warm, cold, step.dt);
    const Vec3 spin_up = torque_alone ? inertia * warm.torque
                                      : (free_spin(warm, cold, step.dt).w - warm.w) / step.dt;
    put(drive.push, acceleration_of(warm, cold, world.def.gravity) * h, spin_up * h);
}

// Euler's equations for one sub-step. Within a step the spin of a tumbling body is that in the
// frame in which it stood at the start and turns with it since; finalize() turns it back into the
// world.
void tumble(HotBody& hot, double h) {
    const float* i = hot.inertia;
    const Mat3 inverse_inertia{{double{i[0]}, double{i[3]}, double{i[4]}},
                               {double{i[3]}, double{i[1]}, double{i[5]}},
                               {double{i[4]}, double{i[5]}, double{i[2]}}};
    const Vec3 start{double{hot.w[0]}, double{hot.w[1]}, double{hot.w[2]}};
    const Vec3 w = euler_step(inverse(inverse_inertia), inverse_inertia, start, h).w;
    // Not an impulse: it counts among what acts without contacts.
    for (int k = 0; k < 3; k++) {
        const float change = as_float(w[k] - start[k]);
        hot.w[k] += change;
        hot.free[3 + k] += change;
    }
}

}  // namespace

Skipped solve_constraints(StepContext& step) {
    if (step.world.bodies.awake.empty()) return nobody_awake;
    WorldState& world = step.world;
    StepScratch& scratch = world.scratch;
    sort_out_bodies(world);
    if (scratch.in_solver.empty()) return "nothing touches and nothing is jointed";
    scratch.hot.resize(world.bodies.awake.size() + 1);
    scratch.drive.resize(world.bodies.awake.size() + 1);
    scratch.hot[0] = {};
    const auto each_range = [&](auto&& work) {
        step.team.run(static_cast<int>(scratch.in_solver.size()), 256, work);
    };
    scratch.tumbling.assign(world.bodies.awake.size() + 1, 0);
    each_range([&](int begin, int end) {
        for (int k = begin; k < end; k++) {
            const std::uint32_t hot = scratch.in_solver[static_cast<std::size_t>(k)];
            prepare_body(step, hot - 1, scratch.hot[hot], scratch.drive[hot]);
            const BodyWarm& warm = world.bodies.awake[hot - 1];
            scratch.tumbling[hot] = tumbles(warm, world.bodies.cold[warm.body], step.dt) ? 1 : 0;
        }
    });
    const auto range = [&](int begin, int end) {
        return BodyRange{scratch.hot.data(), scratch.drive.data(), scratch.in_solver.data(), begin,
                         end};
    };

    prepare_joints(step);
    ManifoldStore& manifolds = world.manifolds;
    const std::span<HotBody> bodies = scratch.hot;
    const Kernels& kernel = kernels();
    const bool bouncy = begin_bounces(manifolds, bodies, step.contacts, step.team);
    for (int n = 0; n < step.contacts.substeps; n++) {
        const bool first = n == 0, last = n + 1 == step.contacts.substeps;
        each_range([&](int begin, int end) {
            (first ? kernel.accelerate_first : kernel.accelerate)(range(begin, end));
        });
        if (first && bouncy) foresee_bounces(manifolds, bodies, step.contacts, step.team);
        // Later sub-steps are warm started by accelerate().
        warm_start_joints(step);
        if (first) warm_start(manifolds, bodies, step.contacts, step.team);
        solve_joints(step, false);
        solve(manifolds, bodies, step.contacts, step.team);
        each_range([&](int begin, int end) {
            for (int k = begin; k < end; k++) {
                const std::uint32_t hot = scratch.in_solver[static_cast<std::size_t>(k)];
                if (scratch.tumbling[hot] != 0) tumble(scratch.hot[hot], double{step.contacts.h});
            }
            kernel.advance(range(begin, end), step.contacts.h);
        });
        solve_joints(step, true);
        relax(manifolds, bodies, step.contacts, last, step.team);
        if (bouncy) note_bounce_peaks(manifolds, bodies, step.contacts, step.team);
    }
    if (bouncy) end_bounces(manifolds, bodies, step.contacts, step.team);
    finish_joints(step);
    return ran;
}

}  // namespace jostle::physics
