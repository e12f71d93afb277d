// SPDX-License-Identifier: MIT
//
// The engines of the accuracy benchmark: Jostle first, then its peers.
#pragma once

#include <span>
#include <string_view>

#include "bench/accuracy/accuracy_engine.h"

namespace jostle::bench::accuracy {

std::span<const EngineKind> engine_kinds();

// Returns null if there is no such engine.
const EngineKind* find_engine_kind(std::string_view name);

// Always built; the factories of peers are declared where they are built.
std::unique_ptr<Engine> make_jostle_engine();

}  // namespace jostle::bench::accuracy
