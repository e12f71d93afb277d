// SPDX-License-Identifier: MIT
//
// The engines of jostle-bench speed.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "bench/speed/engine.h"

namespace jostle::bench {

struct EngineKind {
    const char* name;
    const char* settings;  // settings that differ from the engine's defaults, for --help
    int threads_max;       // 1 if more threads have no effect
    std::unique_ptr<Engine> (*make)();  // null: not included in this build
};

// Jostle first, then its peers.
std::span<const EngineKind> engine_kinds();

// Returns null if there is no such engine.
const EngineKind* find_engine_kind(std::string_view name);

// The Engine adapter for Jostle.
std::unique_ptr<Engine> make_jostle_engine();

// The Engine adapter for Bullet 3. Built only if the library is installed.
std::unique_ptr<Engine> make_bullet_engine();

// The Engine adapter for the Open Dynamics Engine. Built only if the library is installed.
std::unique_ptr<Engine> make_ode_engine();

}  // namespace jostle::bench
