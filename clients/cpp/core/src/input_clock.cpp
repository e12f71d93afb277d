// SPDX-License-Identifier: MIT
#include "jostle/client/input_clock.h"

#include <algorithm>
#include <cmath>

namespace jostle::client {
namespace {

constexpr double mean_weight = 1.0 / 8, jitter_weight = 1.0 / 16, jitter_margin_factor = 4;
constexpr double first_jitter_us = 4000;
// Errors up to one tick are corrected slowly: the margins of single inputs differ by that, and the
// error is not worth a visible change of the speed of predicted motion.
constexpr double speed_correction = 0.05, slow_correction = 0.003, jump_ticks = 10;
constexpr double tolerance_ticks = 0.25;
constexpr int consecutive_margins = 3;
constexpr int margin_timeout_frames = 120;

}  // namespace

void InputClock::begin(double tick_hz) {
    *this = {};
    if (tick_hz > 0 && std::isfinite(tick_hz)) tick_us_ = 1e6 / tick_hz;
    jitter_us_ = first_jitter_us;
}

double InputClock::target_us() const {
    return tick_us_ + jitter_margin_factor * jitter_us_;
}

void InputClock::on_frame(std::uint32_t tick, double due_ago_us, double one_way_us,
                          std::int64_t now_us) {
    const double target = tick + (due_ago_us + one_way_us + target_us()) / tick_us_;
    if (!ready_) {
        ready_ = true;
        position_ = target;
        now_us_ = now_us;
        return;
    }
    // Margins are more accurate, but without inputs there are none.
    const double off = target - position(now_us);
    if (++frames_since_margin_ > margin_timeout_frames && std::abs(off) > jump_ticks) jump(off);
}

void InputClock::on_margin(std::uint32_t sequence, double margin_us) {
    if (sequence <= last_margin_sequence_ || margin_us == 0) return;
    last_margin_sequence_ = sequence;
    frames_since_margin_ = 0;
    if (!measured_) mean_us_ = last_us_ = margin_us;
    measured_ = true;
    // Measured between successive margins: a longer transit time is not jitter.
    const double change_us = std::min(std::abs(margin_us - last_us_), 2 * tick_us_);
    jitter_us_ += jitter_weight * (change_us - jitter_us_);
    last_us_ = margin_us;
    mean_us_ += mean_weight * (margin_us - mean_us_);
    const double off_us = margin_us - target_us();
    if (std::abs(off_us) > jump_ticks * tick_us_) return jump(-off_us / tick_us_);
    adjust_speed(std::abs(off_us) > tick_us_ ? off_us : mean_us_ - target_us());
}

void InputClock::adjust_speed(double off_us) {
    if (std::abs(off_us) < tolerance_ticks * tick_us_) {
        consecutive_out_of_range_ = 0;
        speed_ = 1;
        return;
    }
    correction_us_ = std::abs(off_us);
    consecutive_out_of_range_ = off_us > 0 ? std::max(0, consecutive_out_of_range_) + 1
                                           : std::min(0, consecutive_out_of_range_) - 1;
    const double correction = correction_us_ > tick_us_ ? speed_correction : slow_correction;
    if (consecutive_out_of_range_ >= consecutive_margins) speed_ = 1 - correction;
    if (consecutive_out_of_range_ <= -consecutive_margins) speed_ = 1 + correction;
}

void InputClock::jump(double ticks) {
    position_ += ticks;
    jumps_++;
    speed_ = 1;
    consecutive_out_of_range_ = 0;
    measured_ = false;
    last_margin_sequence_ = std::max(last_margin_sequence_, last_sent_sequence_);
}

double InputClock::position(std::int64_t now_us) {
    if (ready_ && now_us > now_us_) {
        const auto passed_us = static_cast<double>(now_us - now_us_);
        position_ += passed_us * speed_ / tick_us_;
        now_us_ = now_us;
        correction_us_ -= std::abs(speed_ - 1) * passed_us;
        if (correction_us_ <= 0) speed_ = 1;
    }
    return position_;
}

std::uint32_t InputClock::tick(std::int64_t now_us) {
    // The server's times are untrusted.
    return static_cast<std::uint32_t>(std::ceil(std::clamp(position(now_us), 0.0, 4294967295.0)));
}

}  // namespace jostle::client
