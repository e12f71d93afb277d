// SPDX-License-Identifier: MIT
#include "bench/measure.h"

#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <numeric>

#include "jostle/analysis/work_error.h"

namespace jostle::bench {
namespace {

// A line such as "VmRSS:    1234 kB"; see proc(5).
double status_bytes(const char* field) {
    std::ifstream in("/proc/self/status");
    for (std::string word; in >> word;) {
        double kib = 0;
        if (word == field && in >> kib) return 1024 * kib;
    }
    return 0;
}

}  // namespace

double cpu_seconds() {
    return analysis::thread_seconds();
}

double wall_seconds() {
    timespec t{};
    clock_gettime(CLOCK_MONOTONIC, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double memory_bytes() {
    return status_bytes("VmRSS:");
}

double peak_memory_bytes() {
    return status_bytes("VmHWM:");
}

Spread spread_of(std::vector<double> values) {
    if (values.empty()) return {};
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    const double median =
        values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
    return {median, values.front(), values.back()};
}

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double percentile_99(std::vector<double> values) {
    const std::size_t at = std::min(values.size() - 1, values.size() * 99 / 100);
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at),
                     values.end());
    return values[at];
}

std::string cpu_model() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with("model name")) continue;
        const std::size_t at = line.find_first_not_of(" \t", line.find(':') + 1);
        if (at != std::string::npos) return line.substr(at);
    }
    return "unknown";
}

std::string compiler() {
#if defined(__clang__)
    return "clang " __clang_version__;
#else
    return "gcc " __VERSION__;
#endif
}

void show_progress(const std::string& text) {
    static const bool live = isatty(STDERR_FILENO) != 0;
    if (live) std::fprintf(stderr, "\r\033[K%s", text.c_str());
}

}  // namespace jostle::bench
