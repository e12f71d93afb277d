// SPDX-License-Identifier: MIT
#include "modules/particles/src/integrate_particles.h"

namespace jostle::modules::particles_detail {

using namespace physics;

namespace {

using Vectors = std::vector<Vec3>;

// to = from + rate * h
void move(const Vectors& from, const Vectors& rate, double h, Vectors& to) {
    to.resize(from.size());
    for (std::size_t k = 0; k < from.size(); k++) to[k] = from[k] + rate[k] * h;
}

void explicit_euler(const ParticleForces& forces, Vectors& x, Vectors& v, double t, double h,
                    ParticleScratch& s) {
    forces.accelerate(x, v, t, s.acceleration);
    move(x, v, h, x);
    move(v, s.acceleration, h, v);
}

void semi_implicit_euler(const ParticleForces& forces, Vectors& x, Vectors& v, double t, double h,
                         ParticleScratch& s) {
    forces.accelerate(x, v, t, s.acceleration);
    move(v, s.acceleration, h, v);
    move(x, v, h, x);
}

// Half a step of position, a whole step of velocity with the force at the midpoint, half a step of
// position. Velocity-dependent forces use the velocity at the midpoint, extrapolated from the
// start.
void position_verlet(const ParticleForces& forces, Vectors& x, Vectors& v, double t, double h,
                     ParticleScratch& s) {
    move(x, v, 0.5 * h, x);
    if (forces.springs.empty()) {
        forces.accelerate_after(x, v, t + 0.5 * h, 0.5 * h, s.acceleration);
    } else {
        forces.accelerate(x, v, t + 0.5 * h, s.acceleration);
        move(v, s.acceleration, 0.5 * h, s.stage_velocity);
        forces.accelerate(x, s.stage_velocity, t + 0.5 * h, s.acceleration);
    }
    move(v, s.acceleration, h, v);
    move(x, v, 0.5 * h, x);
}

void runge_kutta(const ParticleForces& forces, Vectors& x, Vectors& v, double t, double h,
                 ParticleScratch& s) {
    s.start_velocity = v;
    s.position_rate = v;
    forces.accelerate(x, v, t, s.acceleration);
    s.velocity_rate = s.acceleration;
    s.stage_velocity = v;
    constexpr double fraction[] = {0.5, 0.5, 1};
    constexpr double weight[] = {2, 2, 1};
    for (int stage = 0; stage < 3; stage++) {
        move(x, s.stage_velocity, fraction[stage] * h, s.stage_position);
        move(s.start_velocity, s.acceleration, fraction[stage] * h, s.stage_velocity);
        forces.accelerate(s.stage_position, s.stage_velocity, t + fraction[stage] * h,
                          s.acceleration);
        for (std::size_t k = 0; k < x.size(); k++) {
            s.position_rate[k] += s.stage_velocity[k] * weight[stage];
            s.velocity_rate[k] += s.acceleration[k] * weight[stage];
        }
    }
    move(x, s.position_rate, h / 6, x);
    move(v, s.velocity_rate, h / 6, v);
}

Vec3 tracer_step(ParticleIntegrator integrator, const ParticleForces& forces, Vec3 x, double t,
                 double h) {
    const auto u = [&](Vec3 at, double time) { return forces.medium(at, time); };
    switch (integrator) {
        case ParticleIntegrator::explicit_euler:
        case ParticleIntegrator::semi_implicit_euler:
            break;
        case ParticleIntegrator::implicit_euler: {
            Vec3 end = x + u(x, t) * h;
            for (int k = 0; k < 30; k++) {
                const Vec3 next = x + u(end, t + h) * h;
                const bool done = length_squared(next - end) < 1e-28;
                end = next;
                if (done) break;
            }
            return end;
        }
        case ParticleIntegrator::verlet:  // the midpoint method, of the same order
            return x + u(x + u(x, t) * (0.5 * h), t + 0.5 * h) * h;
        case ParticleIntegrator::runge_kutta_4: {
            const Vec3 k1 = u(x, t), k2 = u(x + k1 * (0.5 * h), t + 0.5 * h);
            const Vec3 k3 = u(x + k2 * (0.5 * h), t + 0.5 * h), k4 = u(x + k3 * h, t + h);
            return x + (k1 + k2 * 2 + k3 * 2 + k4) * (h / 6);
        }
    }
    return x + u(x, t) * h;
}

}  // namespace

void integrate_tracers(ParticleIntegrator integrator, const ParticleForces& forces, Vectors& x,
                       Vectors& v, double t, double h) {
    struct Task {
        ParticleIntegrator integrator;
        const ParticleForces& forces;
        Vectors &x, &v;
        double t, h;
    } task{integrator, forces, x, v, t, h};
    for_ranges(forces.environment.world, x.size(), 64, [&task](int first, int last) {
        for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(last); k++) {
            const Vec3 end = tracer_step(task.integrator, task.forces, task.x[k], task.t, task.h);
            task.v[k] = (end - task.x[k]) * (1 / task.h);
            task.x[k] = end;
        }
    });
}

void integrate_particles(ParticleIntegrator integrator, const ParticleForces& forces, Vectors& x,
                         Vectors& v, double t, double h, ParticleScratch& s) {
    if (forces.def.follow_flow) return integrate_tracers(integrator, forces, x, v, t, h);
    s.acceleration.resize(x.size());
    switch (integrator) {
        case ParticleIntegrator::explicit_euler:
            return explicit_euler(forces, x, v, t, h, s);
        case ParticleIntegrator::semi_implicit_euler:
            return semi_implicit_euler(forces, x, v, t, h, s);
        case ParticleIntegrator::implicit_euler:
            return implicit_euler(forces, x, v, t, h, s);
        case ParticleIntegrator::verlet:
            return position_verlet(forces, x, v, t, h, s);
        case ParticleIntegrator::runge_kutta_4:
            return runge_kutta(forces, x, v, t, h, s);
    }
}

}  // namespace jostle::modules::particles_detail
