// SPDX-License-Identifier: MIT
#include "jostle/client/render_clock.h"

#include <algorithm>
#include <vector>

namespace jostle::client {
namespace {

constexpr std::size_t arrivals_max = 256;
constexpr int frames_per_update = 8;
constexpr double rest_us = 200'000, frame_gap_us = 500'000, delay_max_us = 300'000;
// Frames whose spacing is below this share of their interval arrived in a burst.
constexpr double burst_interval_ratio = 0.25;
constexpr double intervals_behind = 1.7, jitter_percentile = 0.95;
// Share of the difference to the target delay, per frame.
constexpr double delay_growth_rate = 1.0 / 60, delay_shrink_rate = 1.0 / 240;
constexpr double speed_change_max = 0.08, settle_us = 500'000, jump_us = 1'000'000;

double percentile(std::vector<double>& values, double share) {
    const auto at = values.begin() +
                    static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

}  // namespace

void RenderClock::on_frame(std::int64_t server_us, std::int64_t arrived_us, bool after_rest) {
    const bool first = arrivals_.empty();
    if (!first && server_us <= newest_us_) return;
    const auto interval = static_cast<double>(first ? 0 : server_us - newest_us_);
    const double gap = static_cast<double>(first ? 0 : arrived_us - arrived_us_);
    gap_ended_ = (gap > frame_gap_us && !after_rest) ||
                 (gap_ended_ && gap < burst_interval_ratio * interval);
    arrivals_.push_back({static_cast<double>(arrived_us - server_us), interval,
                         !first && !after_rest && interval < rest_us && !gap_ended_});
    if (arrivals_.size() > arrivals_max) arrivals_.pop_front();
    newest_us_ = server_us;
    arrived_us_ = arrived_us;
    adapt();
}

void RenderClock::adapt() {
    min_lateness_us_ = arrivals_.front().lateness_us;
    for (const Arrival& arrival : arrivals_)
        min_lateness_us_ = std::min(min_lateness_us_, arrival.lateness_us);
    if (frames_until_update_-- == 0) {
        frames_until_update_ = frames_per_update - 1;
        update_target_delay();
    }
    const double share = target_delay_us_ > delay_us_ ? delay_growth_rate : delay_shrink_rate;
    delay_us_ += share * (target_delay_us_ - delay_us_);
}

void RenderClock::update_target_delay() {
    std::vector<double> intervals, late;
    for (const Arrival& arrival : arrivals_) {
        if (!arrival.counts_for_jitter) continue;
        intervals.push_back(arrival.interval_us);
        late.push_back(arrival.lateness_us - min_lateness_us_);
    }
    if (late.empty()) return;
    const double interval = percentile(intervals, 0.5),
                 jitter = percentile(late, jitter_percentile);
    target_delay_us_ =
        std::min(delay_max_us, std::max(intervals_behind * interval, interval + jitter));
}

std::int64_t RenderClock::advance(std::int64_t now_us) {
    if (arrivals_.empty()) return 0;
    const double target = static_cast<double>(now_us) - min_lateness_us_ - delay_us_;
    if (!started_) {
        started_ = true;
        now_us_ = now_us;
        render_time_us_ = target;
    }
    if (now_us <= now_us_) return render_time_us();
    const auto passed = static_cast<double>(now_us - now_us_);
    now_us_ = now_us;
    const double behind = target - (render_time_us_ + passed);
    if (behind > jump_us) {
        render_time_us_ = target;
        speed_ = 1;
        return render_time_us();
    }
    const double most = speed_change_max * passed;
    const double change = std::clamp(behind * std::min(1.0, passed / settle_us), -most, most);
    render_time_us_ += passed + change;
    speed_ = 1 + change / passed;
    return render_time_us();
}

}  // namespace jostle::client
