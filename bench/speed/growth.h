// SPDX-License-Identifier: MIT
//
// Growth curves: the cost per step and body as a pile grows in number of bodies, but not in depth.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "bench/speed/engine_kinds.h"

namespace jostle::bench {

inline constexpr int growth_steps_before = 300;  // most of the pile has settled by then
inline constexpr int growth_steps_timed = 60;

struct GrowthRow {
    std::string engine;
    int threads = 1;
    int bodies = 0;                     // dynamic bodies
    std::optional<std::string> failed;  // the reason why there are no values
    double ms_mean = 0;                 // mean of the timed steps
    std::string clock;                  // "cpu" or "wall"
    double bytes_per_body = 0;          // peak memory of the process without the scene description
};

nlohmann::ordered_json to_json(const GrowthRow& row);
GrowthRow growth_row_from(const nlohmann::ordered_json& json);

// Measures bench_pile(bodies) with one engine in a child process.
GrowthRow measure_growth_in_child(const EngineKind& engine, int threads, int bodies);

}  // namespace jostle::bench
