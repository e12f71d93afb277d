// SPDX-License-Identifier: MIT
//
// The engines of the accuracy benchmark: Jostle first, then its peers.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "bench/accuracy/accuracy_engine.h"

namespace jostle::bench::accuracy {

std::span<const EngineKind> engine_kinds();

// Returns null if there is no such engine.
const EngineKind* find_engine_kind(std::string_view name);

// Always built.
std::unique_ptr<Engine> make_jostle_engine();

// Box2D adapter of the accuracy benchmark, for planar scenes. Its y axis is the z axis of the
// scene.
std::unique_ptr<Engine> make_box2d_accuracy_engine();

// MuJoCo adapter of the accuracy benchmark: connected bodies become a kinematic tree, joints that
// close a loop become equality constraints.
std::unique_ptr<Engine> make_mujoco_accuracy_engine();

// ODE adapter of the accuracy benchmark.
std::unique_ptr<Engine> make_ode_accuracy_engine();

}  // namespace jostle::bench::accuracy
