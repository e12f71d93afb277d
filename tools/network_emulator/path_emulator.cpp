// SPDX-License-Identifier: MIT
#include "tools/network_emulator/path_emulator.h"

#include <algorithm>
#include <cmath>

namespace jostle::network_emulator {
namespace {

Clock::duration link_seconds(double s) {
    return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(s));
}

}  // namespace

PathEmulator::PathEmulator(const NetworkConditions& settings, std::uint64_t stream,
                           Clock::time_point now)
    : settings_(settings),
      generator_(settings.seed * 0x9e3779b97f4a7c15ull + stream),
      free_at_(now),
      last_(now),
      stall_begins_(now),
      stall_ends_(now) {}

// The distributions of the standard library differ between platforms.
double PathEmulator::random() {
    return static_cast<double>(generator_() >> 11) * 0x1p-53;
}

// Advances to the current or the next stall.
void PathEmulator::advance_stalls(Clock::time_point until) {
    while (stall_ends_ <= until) {
        const double pause = -settings_.stall_every_s * std::log(1 - random());
        stall_begins_ = stall_ends_ + link_seconds(pause);
        stall_ends_ = stall_begins_ + link_seconds(settings_.stall_ms / 1000);
    }
}

Clock::time_point PathEmulator::arrival_time(std::size_t bytes, Clock::time_point now) {
    free_at_ = std::max(free_at_, now);
    if (settings_.kbit_per_second > 0)
        free_at_ += link_seconds(8e-3 * static_cast<double>(bytes) / settings_.kbit_per_second);
    Clock::time_point at =
        free_at_ + link_seconds((settings_.delay_ms + settings_.jitter_ms * random()) / 1000);
    if (settings_.stall_every_s > 0 && settings_.stall_ms > 0) {
        advance_stalls(at);
        if (at >= stall_begins_) at = stall_ends_;
    }
    return last_ = std::max(last_, at);
}

}  // namespace jostle::network_emulator
