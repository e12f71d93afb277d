// SPDX-License-Identifier: MIT
//
// Implicit Euler. The correction dv of a Newton iteration solves
//     (I - h da/dv - h^2 da/dx) dv = v - v0 - h a(x0 + h v, v, t + h).
// Without springs the matrix consists of a 3 x 3 block per particle. Springs couple the blocks of
// their ends; the system is then solved by conjugate gradients with the blocks as preconditioner
// (D. Baraff, A. Witkin, "Large steps in cloth simulation", SIGGRAPH 1998). The derivative of a
// compressed spring across its direction is left out, so that the matrix stays positive definite
// (K.-J. Choi, H.-S. Ko, "Stable but responsive cloth", SIGGRAPH 2002).
#include "modules/particles/src/integrate_particles.h"

namespace jostle::modules::particles_detail {

using namespace physics;

namespace {

using Vectors = std::vector<Vec3>;

constexpr int newton_iterations_max = 12;
constexpr int solver_iterations_max = 150;

SpringBlock block_of(const ParticleSpring& spring, const Vectors& x, const Vectors& v, double mass,
                     double h) {
    const SpringState state(spring, x, v);
    const double stiff = h * h * spring.stiffness / mass;
    SpringBlock block{.n = state.direction,
                      .along = stiff + h * spring.damping / mass,
                      .across = state.length > spring.rest_length
                                    ? stiff * (1 - spring.rest_length / state.length)
                                    : 0};
    // A spring of length 0 and rest length 0 has no direction and pulls equally along all.
    if (state.length == 0 && spring.rest_length == 0) block.across = stiff;
    return block;
}

Vec3 times(const SpringBlock& block, Vec3 p) {
    return block.n * ((block.along - block.across) * dot(block.n, p)) + p * block.across;
}

Mat3 matrix_of(const SpringBlock& block) {
    return {times(block, {1, 0, 0}), times(block, {0, 1, 0}), times(block, {0, 0, 1})};
}

double dot_of(const Vectors& a, const Vectors& b) {
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); k++) sum += dot(a[k], b[k]);
    return sum;
}

// The linear system of one iteration, at the state in stage_position and stage_velocity.
class NewtonSystem {
public:
    NewtonSystem(const ParticleForces& forces, double h, ParticleScratch& scratch)
        : forces_(forces), h_(h), s_(scratch) {}

    void build(double end_time) {
        const std::size_t count = s_.stage_position.size();
        s_.block.resize(count), s_.inverse_block.resize(count);
        for (std::size_t k = 0; k < count; k++)
            s_.block[k] = Mat3{} - forces_.stiffness(s_.stage_position[k], s_.stage_velocity[k],
                                                     end_time, h_);
        for (std::size_t k = 0; k < count; k++) s_.inverse_block[k] = s_.block[k];
        s_.spring_block.clear();
        for (const ParticleSpring& spring : forces_.springs) {
            s_.spring_block.push_back(
                block_of(spring, s_.stage_position, s_.stage_velocity, forces_.def.mass, h_));
            const Mat3 m = matrix_of(s_.spring_block.back());
            s_.inverse_block[spring.a] = s_.inverse_block[spring.a] + m;
            if (spring.b != spring_anchor)
                s_.inverse_block[spring.b] = s_.inverse_block[spring.b] + m;
        }
        for (std::size_t k = 0; k < count; k++) s_.inverse_block[k] = inverse(s_.inverse_block[k]);
    }

    // Writes the correction for the residual. Changes the residual.
    void solve() {
        const std::size_t count = s_.residual.size();
        s_.correction.resize(count);
        if (forces_.springs.empty()) {
            for (std::size_t k = 0; k < count; k++)
                s_.correction[k] = s_.inverse_block[k] * s_.residual[k];
            return;
        }
        conjugate_gradients();
    }

private:
    void multiply(const Vectors& p, Vectors& out) const {
        for (std::size_t k = 0; k < p.size(); k++) out[k] = s_.block[k] * p[k];
        for (std::size_t k = 0; k < forces_.springs.size(); k++) {
            const ParticleSpring& spring = forces_.springs[k];
            const bool fixed = spring.b == spring_anchor;
            const Vec3 y =
                times(s_.spring_block[k], fixed ? p[spring.a] : p[spring.a] - p[spring.b]);
            out[spring.a] += y;
            if (!fixed) out[spring.b] -= y;
        }
    }

    void conjugate_gradients() {
        const std::size_t count = s_.residual.size();
        s_.product.resize(count);
        Vectors& preconditioned = s_.velocity_rate;
        preconditioned.resize(count);
        const auto precondition = [&] {
            for (std::size_t k = 0; k < count; k++)
                preconditioned[k] = s_.inverse_block[k] * s_.residual[k];
        };
        std::fill(s_.correction.begin(), s_.correction.end(), Vec3{});
        precondition();
        s_.direction = preconditioned;
        double energy = dot_of(s_.residual, preconditioned);
        const double enough = energy * 1e-22;
        for (int n = 0; n < solver_iterations_max && energy > enough; n++) {
            multiply(s_.direction, s_.product);
            const double curvature = dot_of(s_.direction, s_.product);
            if (!(curvature > 0)) return;  // not positive definite: keep the correction so far
            const double size = energy / curvature;
            for (std::size_t k = 0; k < count; k++) {
                s_.correction[k] += s_.direction[k] * size;
                s_.residual[k] -= s_.product[k] * size;
            }
            precondition();
            const double next = dot_of(s_.residual, preconditioned);
            const double ratio = next / energy;
            for (std::size_t k = 0; k < count; k++)
                s_.direction[k] = preconditioned[k] + s_.direction[k] * ratio;
            energy = next;
        }
    }

    const ParticleForces& forces_;
    double h_;
    ParticleScratch& s_;
};

}  // namespace

void implicit_euler(const ParticleForces& forces, Vectors& x, Vectors& v, double t, double h,
                    ParticleScratch& s) {
    const std::size_t count = x.size();
    s.stage_velocity = v;
    s.stage_position.resize(count), s.residual.resize(count);
    NewtonSystem system(forces, h, s);
    for (int n = 0; n < newton_iterations_max; n++) {
        for (std::size_t k = 0; k < count; k++)
            s.stage_position[k] = x[k] + s.stage_velocity[k] * h;
        forces.accelerate(s.stage_position, s.stage_velocity, t + h, s.acceleration);
        for (std::size_t k = 0; k < count; k++)
            s.residual[k] = s.stage_velocity[k] - v[k] - s.acceleration[k] * h;
        system.build(t + h);
        system.solve();
        double moved = 0, speed = 0;
        for (std::size_t k = 0; k < count; k++) {
            s.stage_velocity[k] -= s.correction[k];
            moved = maximum(moved, length_squared(s.correction[k]));
            speed = maximum(speed, length_squared(s.stage_velocity[k]));
        }
        if (moved <= 1e-22 * speed) break;
    }
    v = s.stage_velocity;
    for (std::size_t k = 0; k < count; k++) x[k] += v[k] * h;
}

}  // namespace jostle::modules::particles_detail
