// SPDX-License-Identifier: MIT
//
// The engines that the laboratory knows.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "bench/speed/engine.h"

namespace jostle::bench {

struct EngineKind {
    const char* name;
    const char* settings;               // what differs from its defaults, for --help
    int threads_max;                    // 1 when there is nothing to gain from more
    std::unique_ptr<Engine> (*make)();  // null when this build was made without it
};

// Jostle first, then its peers.
std::span<const EngineKind> engine_kinds();

// Null when there is no such engine.
const EngineKind* find_engine_kind(std::string_view name);

}  // namespace jostle::bench
