// SPDX-License-Identifier: MIT
//
// One row of the speed table: a scene, an engine and a number of threads, with its cost and
// accuracy. Lengths are in metres, as the names state.
#pragma once
#include <nlohmann/json.hpp>

#include <optional>
#include <string>

#include "bench/speed/engine_kinds.h"
#include "bench/speed/speed_scenes.h"

namespace jostle::bench {

struct SpeedRow {
    std::string scene, name;  // letter and name
    std::string engine;
    int threads = 1;
    int steps = 0;
    ParameterValues parameters;         // those of the scene
    std::optional<std::string> failed;  // the reason why there are no values

    int bodies = 0;
    double ms_mean = 0, ms_p99 = 0;  // of a step
    double ms_first = 0;             // the first step, which creates all contacts
    double ms_worst = 0;             // of all steps except the first
    // The most expensive stage of the slowest step; null if the engine does not report it.
    std::optional<std::string> worst_stage;
    // Mean over the steps in which at least 5 % of the dynamic bodies are faster than 5 cm/s, and
    // over the others, without the first step. Null if there are no such steps or no accuracy
    // check.
    std::optional<double> ms_moving_mean, ms_rest_mean;
    std::string clock;  // "cpu": of the thread that steps; "wall"

    // From the accuracy check; null without it. Those of joints are null in scenes without joints.
    std::optional<double> max_penetration_m, peak_penetration_m, mean_penetration_m;
    std::optional<int> contacts_over_1cm;
    std::optional<double> joint_drift_m, peak_joint_drift_m;
    std::optional<int> bodies_lost;  // bodies whose pose is not finite
    std::optional<bool> repeats;     // the accuracy run ended in the same poses as the timed run

    // Null: never, or sleeping is disabled. A driven player is released after the last step.
    std::optional<int> asleep_at_step;
    // Null if sleeping is disabled: bodies awake at the end, and bodies faster than 5 cm/s.
    std::optional<int> awake_at_end, moving_at_end;
    double top_m = 0;  // height of the highest centre of a dynamic body at the end
    std::optional<int> tunnelled;
    double rss_mib = 0;  // peak of the process, including the scene

    // The larger of deepest overlap and joint drift at the end, m.
    std::optional<double> error_m() const;
};

nlohmann::ordered_json to_json(const SpeedRow& row);
SpeedRow speed_row_from(const nlohmann::ordered_json& json);

// The row to measure.
struct RowRequest {
    const SpeedScene* scene = nullptr;
    const EngineKind* engine = nullptr;  // must be built in
    int threads = 1;
    int steps = 0;  // 0: the scene's default
    bool sleep = false;
    bool accuracy = true;
    ParameterValues parameters = {};  // empty: the default of the scene
};

// Times only the steps of the scene. Accuracy is checked in a second run of the same steps, because
// the check would change the content of the caches. The row records whether both runs end in the
// same poses.
SpeedRow measure_row(const RowRequest& request);

// The same in a child process.
SpeedRow measure_row_in_child(const RowRequest& request);

}  // namespace jostle::bench
