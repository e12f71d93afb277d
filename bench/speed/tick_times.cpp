// SPDX-License-Identifier: MIT
#include "bench/speed/server_row.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace jostle::bench {
namespace {

using nlohmann::json;

struct Tick {
    double ms = 0, begun_late_ms = 0;
    int late = 0;  // since the world was created
    bool stepped = false;
};

// Whether a span is a stage of the step.
bool is_stage(const std::string& name) {
    return name != "inputs" && name != "frame_and_results";
}

// In the trace, each tick precedes its stages.
void add_span(std::vector<Tick>& ticks, const json& span) {
    if (span.at("ph") != "X") return;  // metadata
    const std::string& name = span.at("name").get_ref<const std::string&>();
    if (name == "tick") {
        const json& details = span.at("args");
        ticks.push_back({.ms = span.at("dur").get<double>() / 1000,
                         .begun_late_ms = details.at("late_us").get<double>() / 1000,
                         .late = details.at("late_ticks").get<int>()});
    } else if (!ticks.empty() && is_stage(name)) {
        ticks.back().stepped = true;
    }
}

}  // namespace

Result<TickTimes> read_tick_times(const std::string& trace) {
    std::vector<Tick> ticks;
    try {
        const json events = json::parse(trace).at("traceEvents");
        for (const json& span : events) add_span(ticks, span);
    } catch (const json::exception& error) {
        return Error{ErrorCode::corrupt_data,
                     std::string("the profile is not a trace of ticks: ") + error.what()};
    }
    // Skips the ticks before the first step; in a sleeping world no stage runs, but its later ticks
    // count.
    ticks.erase(ticks.begin(), std::find_if(ticks.begin(), ticks.end(),
                                            [](const Tick& tick) { return tick.stepped; }));
    TickTimes times;
    for (const Tick& tick : ticks) {
        times.ms.push_back(tick.ms);
        times.begun_late_ms = std::max(times.begun_late_ms, tick.begun_late_ms);
    }
    if (!ticks.empty()) times.late = ticks.back().late - ticks.front().late;
    return times;
}

}  // namespace jostle::bench
