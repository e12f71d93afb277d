// SPDX-License-Identifier: MIT
//
// Growth curves: what a step and a body cost as a pile grows in count but not in depth.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "bench/speed/engine_kinds.h"

namespace jostle::bench {

inline constexpr int growth_steps_before = 300;  // most of the pile has come down by then
inline constexpr int growth_steps_timed = 60;

struct GrowthRow {
    std::string engine;
    int threads = 1;
    int bodies = 0;                     // that move
    std::optional<std::string> failed;  // why there are no figures
    double ms_mean = 0;                 // of a timed step
    std::string clock;                  // "cpu" or "wall"
    double bytes_per_body = 0;          // what the process took at most beyond the scene itself
};

nlohmann::ordered_json to_json(const GrowthRow& row);
GrowthRow growth_row_from(const nlohmann::ordered_json& json);

// bench_pile(bodies) on one engine, in a child process.
GrowthRow measure_growth_in_child(const EngineKind& engine, int threads, int bodies);

}  // namespace jostle::bench
