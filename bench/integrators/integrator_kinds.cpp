// SPDX-License-Identifier: MIT
#include "bench/integrators/integrator_kinds.h"

#include <array>

namespace jostle::bench::integrators {
namespace {

// Base class of the textbook methods; refers to the field.
class InField : public Integrator {
public:
    explicit InField(const ParticleField& field) : field_(field) {}

protected:
    Vec3 a(Vec3 x, Vec3 v, double t) const { return field_.acceleration(x, v, t); }

private:
    const ParticleField& field_;
};

// x += h v, v += h a(x, v, t), both from the old state. Gains energy on every orbit.
class ExplicitEuler final : public InField {
public:
    using InField::InField;
    void step(ParticleState& s, double t, double h) override {
        const Vec3 acceleration = a(s.position, s.velocity, t);
        s.position += s.velocity * h;
        s.velocity += acceleration * h;
    }
};

// Like explicit Euler, but with the new velocity in the first equation: symplectic, so the energy
// oscillates instead of growing, at no extra cost.
class SemiImplicitEuler final : public InField {
public:
    using InField::InField;
    void step(ParticleState& s, double t, double h) override {
        s.velocity += a(s.position, s.velocity, t) * h;
        s.position += s.velocity * h;
    }
};

// Both equations use the new state: x = x0 + h v, v = v0 + h a(x, v, t + h), three equations in x
// that Newton's method solves with finite differences. Stable for any step; loses energy.
class ImplicitEuler final : public InField {
public:
    using InField::InField;
    void step(ParticleState& s, double t, double h) override {
        const auto residual = [&](Vec3 x) {
            const Vec3 v = (x - s.position) * (1 / h);
            return x - s.position - (s.velocity + a(x, v, t + h) * h) * h;
        };
        constexpr double delta = 1e-6;  // m
        Vec3 x = s.position + s.velocity * h;
        for (int k = 0; k < 20; k++) {
            const Vec3 r = residual(x);
            const Vec3 d[3] = {(residual(x + Vec3{delta, 0, 0}) - r) * (1 / delta),
                               (residual(x + Vec3{0, delta, 0}) - r) * (1 / delta),
                               (residual(x + Vec3{0, 0, delta}) - r) * (1 / delta)};
            const double determinant = dot(d[0], cross(d[1], d[2]));  // Cramer's rule
            const Vec3 move = Vec3{dot(r, cross(d[1], d[2])), dot(r, cross(d[2], d[0])),
                                   dot(r, cross(d[0], d[1]))} *
                              (1 / determinant);
            x -= move;
            if (length_squared(move) < 1e-28) break;
        }
        s.velocity = (x - s.position) * (1 / h);
        s.position = x;
    }
};

// Position Verlet: half a step of position, a whole step of velocity with the force at the
// midpoint, half a step of position. Symplectic and of second order. Velocity-dependent forces use
// the velocity at the midpoint, extrapolated from the old velocity.
class Verlet final : public InField {
public:
    using InField::InField;
    void step(ParticleState& s, double t, double h) override {
        const Vec3 middle = s.position + s.velocity * (0.5 * h);
        const double half = t + 0.5 * h;
        const Vec3 guess = s.velocity + a(middle, s.velocity, half) * (0.5 * h);
        s.velocity += a(middle, guess, half) * h;
        s.position = middle + s.velocity * (0.5 * h);
    }
};

// The classical Runge-Kutta method: four evaluations of the field, fourth order, loses a little
// energy.
class RungeKutta final : public InField {
public:
    using InField::InField;
    void step(ParticleState& s, double t, double h) override {
        const Vec3 x = s.position, v = s.velocity;
        const Vec3 v1 = v, a1 = a(x, v1, t);
        const Vec3 v2 = v + a1 * (0.5 * h), a2 = a(x + v1 * (0.5 * h), v2, t + 0.5 * h);
        const Vec3 v3 = v + a2 * (0.5 * h), a3 = a(x + v2 * (0.5 * h), v3, t + 0.5 * h);
        const Vec3 v4 = v + a3 * h, a4 = a(x + v3 * h, v4, t + h);
        s.position += (v1 + v2 * 2 + v3 * 2 + v4) * (h / 6);
        s.velocity += (a1 + a2 * 2 + a3 * 2 + a4) * (h / 6);
    }
};

}  // namespace

std::unique_ptr<Integrator> make_explicit_euler(const ParticleField& field) {
    return std::make_unique<ExplicitEuler>(field);
}

std::unique_ptr<Integrator> make_semi_implicit_euler(const ParticleField& field) {
    return std::make_unique<SemiImplicitEuler>(field);
}

std::unique_ptr<Integrator> make_implicit_euler(const ParticleField& field) {
    return std::make_unique<ImplicitEuler>(field);
}

std::unique_ptr<Integrator> make_verlet(const ParticleField& field) {
    return std::make_unique<Verlet>(field);
}

std::unique_ptr<Integrator> make_runge_kutta(const ParticleField& field) {
    return std::make_unique<RungeKutta>(field);
}

namespace {

constexpr std::array kinds = {
    IntegratorKind{"explicit", "explicit Euler", 1, make_explicit_euler},
    IntegratorKind{"semi-implicit", "semi-implicit (symplectic) Euler", 1,
                   make_semi_implicit_euler},
    IntegratorKind{"implicit", "implicit Euler, by Newton's method", 1, make_implicit_euler},
    IntegratorKind{"verlet", "position Verlet (leapfrog)", 2, make_verlet},
    IntegratorKind{"rk4", "classical Runge-Kutta method", 4, make_runge_kutta},
    IntegratorKind{"jostle", "a free body in a World of 8 sub-steps, driven by a step listener", 2,
                   make_world_integrator},
};

}  // namespace

std::span<const IntegratorKind> integrator_kinds() {
    return kinds;
}

const IntegratorKind* find_integrator(std::string_view name) {
    for (const IntegratorKind& kind : kinds)
        if (name == kind.name) return &kind;
    return nullptr;
}

}  // namespace jostle::bench::integrators
