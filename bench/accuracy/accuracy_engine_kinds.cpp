// SPDX-License-Identifier: MIT
#include "bench/accuracy/accuracy_engine_kinds.h"

#include "bench/accuracy/bullet_accuracy_library.h"

namespace jostle::bench::accuracy {
namespace {

using Maker = std::unique_ptr<Engine> (*)();

#if JOSTLE_ACCURACY_BULLET
constexpr Maker make_bullet = open_bullet_engine;
#else
constexpr Maker make_bullet = nullptr;
#endif
#if JOSTLE_ACCURACY_ODE
constexpr Maker make_ode = make_ode_accuracy_engine;
#else
constexpr Maker make_ode = nullptr;
#endif
#if JOSTLE_ACCURACY_MUJOCO
constexpr Maker make_mujoco = make_mujoco_accuracy_engine;
#else
constexpr Maker make_mujoco = nullptr;
#endif
#if JOSTLE_ACCURACY_BOX2D
constexpr Maker make_box2d = make_box2d_accuracy_engine;
#else
constexpr Maker make_box2d = nullptr;
#endif

const std::vector<EngineKind>& kinds() {
    static const std::vector<EngineKind> all = {
        {"jostle",
         "double precision, with float in the inner loops; subN: N sub-steps, tolX: a tolerance of "
         "X in metres, iterative: sub8 with all joints solved iteratively, for scenes with joints; "
         "default continuous collision",
         {"sub8", "sub1", "sub4", "sub16", "tol1e-2", "tol1e-3", "iterative"},
         make_jostle_engine},
        {"bullet",
         "double precision; sequential impulses or nonlinear conjugate gradients with N "
         "iterations, or Dantzig's direct solver; thin: contacts begin when "
         "shapes touch, and push apart without leaving velocity; mb: Featherstone's algorithm in "
         "joint coordinates, with an Euler step or RK4, for jointed bodies that touch nothing",
         {"si10", "si4", "si50", "si10-thin", "nncg10", "nncg50", "dantzig", "mb", "mb-rk4"},
         make_bullet},
        {"ode",
         "double precision; QuickStep with N iterations, or the direct step; friction as a "
         "pyramid",
         {"quick20", "quick50", "world"},
         make_ode},
        {"mujoco",
         "double precision; joint coordinates; Newton's method or conjugate gradients with an "
         "integrator; elliptic "
         "cones; hard: constraints as stiff as two steps; no restitution parameter",
         {"newton-euler", "newton-implicit", "newton-rk4", "newton-euler-hard", "newton-rk4-hard",
          "cg-euler-hard"},
         make_mujoco},
        {"box2d",
         "single precision, planar scenes only; N velocity iterations and 3 position iterations",
         {"vel8", "vel4", "vel50"},
         make_box2d},
    };
    return all;
}

}  // namespace

std::span<const EngineKind> engine_kinds() {
    return kinds();
}

const EngineKind* find_engine_kind(std::string_view name) {
    for (const EngineKind& kind : kinds())
        if (name == kind.name) return &kind;
    return nullptr;
}

}  // namespace jostle::bench::accuracy
