// SPDX-License-Identifier: MIT
#include "jostle/client/interpolation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "clients/cpp/core/src/pose_blend.h"

namespace jostle::client {
namespace {

constexpr std::size_t frames_max = 64;
// After a longer gap without rendering, errors are discarded: nothing was displayed that could
// jump.
constexpr std::int64_t sample_gap_max_us = 250'000;

const snapshot::EntityState* find_state(const snapshot::QuantizedFrame& frame, std::uint32_t id) {
    const auto& entities = frame.entities;
    const auto at =
        std::lower_bound(entities.begin(), entities.end(), id,
                         [](const snapshot::EntityState& e, std::uint32_t n) { return e.id < n; });
    return at != entities.end() && at->id == id ? &*at : nullptr;
}

BodySpeed speed_between(const snapshot::Pose& a, const snapshot::Pose& b, double width_us) {
    double dot = 0;
    for (std::size_t k = 0; k < 4; k++) dot += a.rotation[k] * b.rotation[k];
    const double angle = 2 * std::acos(std::min(1.0, std::abs(dot)));
    return {distance(a, b) * 1e6 / width_us, angle * 1e6 / width_us};
}

}  // namespace

void InterpolationBuffer::clear() {
    *this = {};
}

void InterpolationBuffer::add(snapshot::QuantizedFrame frame, std::int64_t server_us,
                              std::int64_t arrived_us, bool after_rest) {
    if (!frames_.empty() && server_us <= frames_.back().server_us) return;
    clock_.on_frame(server_us, arrived_us, after_rest);
    frames_.push_back({std::move(frame), server_us});
    if (frames_.size() > frames_max) frames_.pop_front();
}

void InterpolationBuffer::hold(std::int64_t server_us) {
    if (frames_.empty() || server_us <= frames_.back().server_us) return;
    frames_.push_back({frames_.back().frame, server_us});
    if (frames_.size() > frames_max) frames_.pop_front();
}

InterpolationBuffer::FramePair InterpolationBuffer::frames_around(double at_us) const {
    // The first frame after `at_us`, or the newest frame.
    std::size_t next = 0;
    while (next + 1 < frames_.size() && static_cast<double>(frames_[next].server_us) < at_us)
        next++;
    const Timed &a = frames_[next == 0 ? 0 : next - 1], &b = frames_[next];
    if (a.server_us == b.server_us) return {&a, &b, 1};
    const auto width = static_cast<double>(b.server_us - a.server_us);
    const double t = (at_us - static_cast<double>(a.server_us)) / width;
    return {&a, &b, std::clamp(t, 0.0, 1 + extrapolation_max_us / width)};
}

// Poses without errors.
std::vector<InterpolationBuffer::RenderedPose> InterpolationBuffer::poses_at(
    double at_us, const snapshot::QuantSpec& spec) const {
    const auto [a, b, t] = frames_around(at_us);
    const auto width = static_cast<double>(b->server_us - a->server_us);
    const auto& old = a->frame.entities;
    std::vector<RenderedPose> out;
    out.reserve(b->frame.entities.size());
    std::size_t from = 0;
    for (const snapshot::EntityState& state : b->frame.entities) {
        while (from < old.size() && old[from].id < state.id) from++;
        const snapshot::Pose to = snapshot::dequantize(state, spec);
        RenderedPose& drawn = out.emplace_back(RenderedPose{{state.id, to}, {}, {}});
        if (width == 0 || from == old.size() || old[from].id != state.id) continue;
        const snapshot::Pose before = snapshot::dequantize(old[from], spec);
        if (is_teleport(before, to, width)) {
            if (t < 1) drawn.smooth_pose.pose = before;
            continue;
        }
        drawn.smooth_pose.pose = blend(before, to, t);
        drawn.body_speed = speed_between(before, to, width);
    }
    return out;
}

bool InterpolationBuffer::teleported_since(std::uint32_t entity, std::int64_t server_us,
                                           const snapshot::QuantSpec& spec) const {
    for (std::size_t k = 1; k < frames_.size(); k++) {
        if (frames_[k].server_us <= server_us) continue;
        const snapshot::EntityState* a = find_state(frames_[k - 1].frame, entity);
        const snapshot::EntityState* b = find_state(frames_[k].frame, entity);
        const auto width = static_cast<double>(frames_[k].server_us - frames_[k - 1].server_us);
        if (a && b &&
            is_teleport(snapshot::dequantize(*a, spec), snapshot::dequantize(*b, spec), width))
            return true;
    }
    return false;
}

// The last rendered frame was extrapolated and the missing frames have arrived: computes the
// difference from the correct poses.
void InterpolationBuffer::update_errors(const snapshot::QuantSpec& spec) {
    const auto poses = poses_at(static_cast<double>(last_render_time_us_), spec);
    std::size_t k = 0;
    for (RenderedPose& drawn : rendered_) {
        while (k < poses.size() && poses[k].smooth_pose.entity < drawn.smooth_pose.entity) k++;
        if (k == poses.size() || poses[k].smooth_pose.entity != drawn.smooth_pose.entity) continue;
        drawn.error = smoothable_error(
            pose_error(drawn.smooth_pose.pose, poses[k].smooth_pose.pose), poses[k].body_speed);
        if (!drawn.error.none() &&
            teleported_since(drawn.smooth_pose.entity, last_newest_frame_us_, spec))
            drawn.error = {};
    }
}

std::vector<SmoothPose> InterpolationBuffer::sample(std::int64_t now_us,
                                                    const snapshot::QuantSpec& spec) {
    std::vector<SmoothPose> out;
    if (frames_.empty()) return out;
    const std::int64_t at_us = clock_.advance(now_us);
    const std::int64_t newest_us = frames_.back().server_us;
    const std::int64_t passed_us = std::max<std::int64_t>(0, now_us - last_sample_us_);
    if (passed_us > sample_gap_max_us)
        rendered_.clear();
    else if (last_render_time_us_ > last_newest_frame_us_ && newest_us > last_newest_frame_us_)
        update_errors(spec);

    std::vector<RenderedPose> now = poses_at(static_cast<double>(at_us), spec);
    out.reserve(now.size());
    std::size_t k = 0;
    for (RenderedPose& drawn : now) {
        while (k < rendered_.size() && rendered_[k].smooth_pose.entity < drawn.smooth_pose.entity)
            k++;
        if (k < rendered_.size() && rendered_[k].smooth_pose.entity == drawn.smooth_pose.entity) {
            drawn.error =
                decayed(rendered_[k].error, drawn.body_speed, static_cast<double>(passed_us) / 1e6);
            drawn.smooth_pose.pose = apply_error(drawn.smooth_pose.pose, drawn.error);
        }
        out.push_back(drawn.smooth_pose);
    }
    rendered_ = std::move(now);
    last_sample_us_ = now_us;
    last_render_time_us_ = at_us;
    last_newest_frame_us_ = newest_us;
    return out;
}

}  // namespace jostle::client
