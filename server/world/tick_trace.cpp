// SPDX-License-Identifier: MIT
#include "server/world/tick_trace.h"

#include "jostle/base/check.h"
#include "server/metrics/chrome_trace.h"

namespace jostle::server {

namespace {

constexpr int ticks_row = 0, stages_row = 1;

double us_between(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double, std::micro>(to - from).count();
}

void add_tick(std::vector<TraceSpan>& spans, const TickProfile& tick, Clock::time_point zero) {
    const double begun = us_between(zero, tick.begun), ended = us_between(zero, tick.ended);
    ASSERT(ended >= begun);
    const double step_begun = us_between(zero, tick.step_begun);
    spans.push_back({.name = "tick",
                     .start_us = begun,
                     .duration_us = ended - begun,
                     .row = ticks_row,
                     .details = {{"tick", tick.tick},
                                 {"late_us", us_between(tick.due, tick.begun)},
                                 {"inputs", tick.inputs},
                                 {"bodies_awake", tick.bodies_awake},
                                 {"touching", tick.touching},
                                 {"late_ticks", tick.late_ticks}}});
    const auto add = [&](std::string_view name, double start, double duration) {
        if (duration > 0)
            spans.push_back(
                {.name = name, .start_us = start, .duration_us = duration, .row = stages_row});
    };
    add("inputs", begun, step_begun - begun);
    // The profile holds durations; stages run one after the other.
    double at = step_begun;
    for (int i = 0; i < physics::stage_count; i++) {
        const double duration = 1000 * tick.stage_ms[static_cast<std::size_t>(i)];
        add(physics::stage_name(static_cast<physics::Stage>(i)), at, duration);
        at += duration;
    }
    add("frame_and_results", at, ended - at);
}

}  // namespace

std::string tick_trace(const std::string& world, std::span<const TickProfile> ticks) {
    std::vector<TraceSpan> spans;
    spans.reserve(ticks.size() * (physics::stage_count + 3));
    for (const TickProfile& tick : ticks) add_tick(spans, tick, ticks.front().begun);
    return write_chrome_trace({.process = "world " + world, .rows = {"ticks", "stages"}}, spans);
}

}  // namespace jostle::server
