// SPDX-License-Identifier: MIT
#include "bench/integrators/integrator_kinds.h"

#include <array>

#include "bench/integrators/textbook_integrators.h"
#include "bench/integrators/world_integrator.h"

namespace jostle::bench::integrators {
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
