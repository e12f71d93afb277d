// SPDX-License-Identifier: MIT
#include "bench/speed/engine_kinds.h"

namespace jostle::bench {
namespace {

#if !JOSTLE_BENCH_BULLET
constexpr std::unique_ptr<Engine> (*make_bullet_engine)() = nullptr;
#endif
#if !JOSTLE_BENCH_ODE
constexpr std::unique_ptr<Engine> (*make_ode_engine)() = nullptr;
#endif

constexpr EngineKind kinds[] = {
    {"jostle", "8 sub-steps; continuous collision for all bodies (default)", 64,
     make_jostle_engine},
    {"bullet",
     "sequential impulses, 10 iterations, single precision, one step of 1/60 s without sub-steps; "
     "friction sqrt(0.5) each, as it multiplies; continuous collision only for spheres that start "
     "fast (scene i); a cone_twist joint is a btConeTwistConstraint",
     1, make_bullet_engine},
    {"ode",
     "dWorldQuickStep, 20 iterations, double precision, default ERP and CFM; hash space, at most 4 "
     "contacts a pair, mu 0.5 as a friction pyramid (dContactApprox1); no continuous collision; a "
     "cone_twist joint is a ball joint with an Euler motor, whose stops replace the cone by a "
     "pyramid",
     1, make_ode_engine},
};

}  // namespace

std::span<const EngineKind> engine_kinds() {
    return kinds;
}

const EngineKind* find_engine_kind(std::string_view name) {
    for (const EngineKind& kind : kinds)
        if (name == kind.name) return &kind;
    return nullptr;
}

}  // namespace jostle::bench
