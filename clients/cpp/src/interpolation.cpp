// SPDX-License-Identifier: MIT
#include "jostle/client/interpolation.h"

#include <algorithm>
#include <cmath>

namespace jostle::client {
namespace {

constexpr std::size_t frames_max = 64, lateness_max = 128;
constexpr double extrapolate_us = 50'000;
constexpr double intervals_behind = 1.7, adapt_share = 0.05;

// t in 0..1 between a and b; beyond 1 the motion goes on.
wire::Pose blend(const wire::Pose& a, const wire::Pose& b, double t) {
    wire::Pose out;
    double dot = 0, norm = 0;
    for (std::size_t k = 0; k < 3; k++)
        out.position[k] = a.position[k] + t * (b.position[k] - a.position[k]);
    for (std::size_t k = 0; k < 4; k++) dot += a.rotation[k] * b.rotation[k];
    // Normalised linear interpolation along the shorter way: steps are small.
    for (std::size_t k = 0; k < 4; k++) {
        const double to = dot < 0 ? -b.rotation[k] : b.rotation[k];
        out.rotation[k] = a.rotation[k] + t * (to - a.rotation[k]);
        norm += out.rotation[k] * out.rotation[k];
    }
    for (double& c : out.rotation) c /= std::sqrt(norm);
    return out;
}

}  // namespace

void InterpolationBuffer::clear() {
    *this = {};
}

void InterpolationBuffer::add(const wire::QuantizedFrame& frame, std::int64_t server_us,
                              std::int64_t arrived_us) {
    if (!frames_.empty() && server_us <= frames_.back().server_us) return;
    adapt(server_us, arrived_us);
    frames_.push_back({frame, server_us});
    if (frames_.size() > frames_max) frames_.pop_front();
}

void InterpolationBuffer::hold(std::int64_t server_us) {
    if (frames_.empty() || server_us <= frames_.back().server_us) return;
    frames_.push_back({frames_.back().frame, server_us});
    if (frames_.size() > frames_max) frames_.pop_front();
}

void InterpolationBuffer::adapt(std::int64_t server_us, std::int64_t arrived_us) {
    if (!frames_.empty()) {
        const auto interval = static_cast<double>(server_us - frames_.back().server_us);
        interval_us_ = interval_us_ == 0 ? interval : 0.95 * interval_us_ + 0.05 * interval;
    }
    lateness_us_.push_back(static_cast<double>(arrived_us - server_us));
    if (lateness_us_.size() > lateness_max) lateness_us_.pop_front();
    std::vector<double> sorted(lateness_us_.begin(), lateness_us_.end());
    std::sort(sorted.begin(), sorted.end());
    const double late = sorted[sorted.size() * 95 / 100];
    const double jitter = late - sorted.front();
    // `late` includes the way itself: what is shown lies that far back on the server's clock.
    const double wanted =
        sorted.front() + std::max(intervals_behind * interval_us_, interval_us_ + jitter);
    const double most = std::max(1000.0, adapt_share * delay_us_);
    delay_us_ = delay_us_ == 0 ? wanted : delay_us_ + std::clamp(wanted - delay_us_, -most, most);
}

std::vector<SmoothPose> InterpolationBuffer::sample(std::int64_t now_us,
                                                    const wire::QuantSpec& spec) const {
    std::vector<SmoothPose> out;
    if (frames_.empty()) return out;
    const double at = static_cast<double>(now_us) - delay_us_;
    // The first frame after `at`, or the newest.
    std::size_t next = 0;
    while (next + 1 < frames_.size() && static_cast<double>(frames_[next].server_us) < at) next++;
    const Timed& b = frames_[next];
    const Timed& a = frames_[next == 0 ? 0 : next - 1];
    double t = 1;
    if (b.server_us > a.server_us) {
        const auto width = static_cast<double>(b.server_us - a.server_us);
        t = std::clamp((at - static_cast<double>(a.server_us)) / width, 0.0,
                       1 + extrapolate_us / width);
    }
    std::size_t from = 0;
    out.reserve(b.frame.entities.size());
    for (const wire::EntityState& state : b.frame.entities) {
        const auto& old = a.frame.entities;
        while (from < old.size() && old[from].id < state.id) from++;
        const wire::Pose to = wire::dequantize(state, spec);
        const bool known = from < old.size() && old[from].id == state.id;
        out.push_back({state.id, known ? blend(wire::dequantize(old[from], spec), to, t) : to});
    }
    return out;
}

}  // namespace jostle::client
