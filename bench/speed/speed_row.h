// SPDX-License-Identifier: MIT
//
// One line of the speed table: a scene, an engine and a number of threads, what it cost and
// how right it was. Lengths are metres, as the names say.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace jostle::bench {

struct SpeedRow {
    std::string scene, name;  // letter and name
    std::string engine;
    int threads = 1;
    int steps = 0;
    std::optional<std::string> failed;  // why there are no figures

    int bodies = 0;
    double ms_mean = 0, ms_p99 = 0;  // of a step
    double ms_first = 0;             // the first step, in which all is found for the first time
    double ms_worst = 0;             // of all but the first
    // The stage that took most of the worst step; null of an engine that does not say.
    std::optional<std::string> worst_stage;
    // While a twentieth of the dynamic bodies are faster than 5 cm/s, and while not; without the
    // first step. Null where there are no such steps, or no check for accuracy.
    std::optional<double> ms_moving_mean, ms_rest_mean;
    std::string clock;  // "cpu": of the thread that steps; "wall"

    // The accuracy check's; null without it, and those of joints where there are none.
    std::optional<double> max_penetration_m, peak_penetration_m, mean_penetration_m;
    std::optional<int> contacts_over_1cm;
    std::optional<double> joint_drift_m, peak_joint_drift_m;
    std::optional<int> bodies_lost;  // whose pose is not a number any more
    std::optional<bool> repeats;  // the run for accuracy ended in the same poses as the timed one

    // Null: never, or not allowed to. A player who was driven is let go after the last step.
    std::optional<int> asleep_at_step;
    // Null where nobody may sleep: who is not asleep at the end, and who is faster than 5 cm/s.
    std::optional<int> awake_at_end, moving_at_end;
    double top_m = 0;  // of the highest centre of a body that moves, at the end
    std::optional<int> tunnelled;
    double rss_mib = 0;  // peak of the process, scene included

    // What the plot calls wrong: the larger of deepest overlap and joint drift at the end, m.
    std::optional<double> error_m() const;
};

nlohmann::ordered_json to_json(const SpeedRow& row);
SpeedRow speed_row_from(const nlohmann::ordered_json& json);

}  // namespace jostle::bench
