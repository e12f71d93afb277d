// SPDX-License-Identifier: MIT
//
// Writes Chrome's trace format: durations as JSON for chrome://tracing, ui.perfetto.dev and
// speedscope.app. Pure functions.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace jostle::server {

// A span on a row of the trace. The format calls rows threads; spans on one row do not overlap, or
// are nested.
struct TraceSpan {
    std::string_view name;  // must outlive the call of write_chrome_trace()
    double start_us = 0;
    double duration_us = 0;
    int row = 0;
    // Numbers by name; the viewer displays them when the span is selected.
    std::vector<std::pair<std::string_view, double>> details = {};
};

struct TraceRows {
    std::string process;            // title of the trace
    std::vector<std::string> rows;  // title of each row, by number
};

std::string write_chrome_trace(const TraceRows& titles, const std::vector<TraceSpan>& spans);

}  // namespace jostle::server
