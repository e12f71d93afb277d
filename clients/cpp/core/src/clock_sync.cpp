// SPDX-License-Identifier: MIT
#include "jostle/client/clock_sync.h"

#include <algorithm>

namespace jostle::client {
namespace {

constexpr std::uint64_t sample_life_us = 30'000'000;

}  // namespace

void ClockSync::add(std::uint64_t sent_us, std::uint64_t server_us, std::uint64_t now_us) {
    if (now_us < sent_us) return;  // not an echo of this client
    if (server_us > latest_time_us) return;
    const auto rtt = static_cast<std::int64_t>(now_us - sent_us);
    // The server's time was valid half a round trip ago.
    const std::int64_t offset =
        static_cast<std::int64_t>(server_us) - static_cast<std::int64_t>(sent_us) - rtt / 2;
    samples_.push_back({offset, rtt, now_us});
    while (samples_.front().at_us + sample_life_us < now_us) samples_.pop_front();
    const auto best = std::min_element(samples_.begin(), samples_.end(),
                                       [](auto& a, auto& b) { return a.rtt_us < b.rtt_us; });
    offset_us_ = best->offset_us;
}

double ClockSync::rtt_ms() const {
    std::int64_t best = samples_.empty() ? 0 : samples_.front().rtt_us;
    for (const Sample& sample : samples_) best = std::min(best, sample.rtt_us);
    return static_cast<double>(best) / 1000;
}

}  // namespace jostle::client
