// SPDX-License-Identifier: MIT
//
// Chrome's trace format: what took how long, as JSON that chrome://tracing, ui.perfetto.dev and
// speedscope.app draw. Pure functions.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace jostle::server {

// A bar of a row. Rows are threads in the words of the format; bars of one row lie side by side or
// inside each other.
struct TraceSpan {
    std::string_view name;  // outlives the call of write_chrome_trace()
    double start_us = 0;
    double duration_us = 0;
    int row = 0;
    // Shown when the bar is clicked: numbers by name.
    std::vector<std::pair<std::string_view, double>> details = {};
};

struct TraceRows {
    std::string process;            // the title of all
    std::vector<std::string> rows;  // the title of each row, by number
};

std::string write_chrome_trace(const TraceRows& titles, const std::vector<TraceSpan>& spans);

}  // namespace jostle::server
