// SPDX-License-Identifier: MIT
#include "jostle/client/rendered_time.h"

#include <algorithm>
#include <cmath>

#include "clients/cpp/core/src/pose_blend.h"

namespace jostle::client {
namespace {

constexpr std::int64_t rendering_timeout_us = 1'000'000;

}  // namespace

v1::ViewTime rendered_time(const NewestFrame& newest, std::int64_t render_time_us, double tick_us) {
    v1::ViewTime view_time;
    view_time.set_tick(newest.frame);
    if (render_time_us == 0 || render_time_us < newest.due_us - rendering_timeout_us ||
        tick_us <= 0)
        return view_time;
    const double after_us =
        std::min(static_cast<double>(render_time_us - newest.due_us), extrapolation_max_us);
    const double tick = std::max(1.0, newest.frame + after_us / tick_us);
    view_time.set_tick(static_cast<std::uint32_t>(tick));
    view_time.set_fraction(static_cast<float>(tick - std::floor(tick)));
    return view_time;
}

}  // namespace jostle::client
