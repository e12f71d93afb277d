// SPDX-License-Identifier: MIT
//
// The engines that the laboratory knows: Jostle first, then its peers.
#pragma once

#include <span>
#include <string_view>

#include "bench/accuracy/accuracy_engine.h"

namespace jostle::bench::accuracy {

std::span<const EngineKind> engine_kinds();

// Null when there is no such engine.
const EngineKind* find_engine_kind(std::string_view name);

// Built with the project; the peers' are declared where they are built in.
std::unique_ptr<Engine> make_jostle_engine();

}  // namespace jostle::bench::accuracy
