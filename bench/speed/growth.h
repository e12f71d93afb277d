// SPDX-License-Identifier: MIT
//
// Growth curves: the cost per step and body as a scene grows. A pile grows in number of bodies but
// not in depth; a chain grows in length.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/speed/engine_kinds.h"

namespace jostle::bench {

inline constexpr int growth_steps_before = 300;  // most of the pile has settled by then
inline constexpr int growth_steps_timed = 60;

// A scene that grows.
struct GrowthScene {
    const char* name;
    scenes::SceneDescription (*make)(int bodies);  // with this number of dynamic bodies
};
std::span<const GrowthScene> growth_scenes();
// Null if there is no such scene.
const GrowthScene* find_growth_scene(std::string_view name);

struct GrowthRow {
    std::string scene;
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

// Measures the scene with one engine in a child process.
GrowthRow measure_growth_in_child(const GrowthScene& scene, const EngineKind& engine, int threads,
                                  int bodies);

// The exponent p of ms_mean = c * bodies^p for one engine and number of threads.
struct GrowthFit {
    std::string engine;
    int threads = 1;
    // Slope of the line through (log bodies, log ms_mean) with the least sum of squared errors.
    // Null if fewer than two numbers of bodies have a time.
    std::optional<double> exponent;
};

// One fit for each engine and number of threads, in the order of their first rows. Skips failed
// rows.
std::vector<GrowthFit> fit_growth(std::span<const GrowthRow> rows);

nlohmann::ordered_json to_json(const GrowthFit& fit);

}  // namespace jostle::bench
