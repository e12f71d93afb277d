// SPDX-License-Identifier: MIT
#include "jostle/client/rendered_time.h"

#include <algorithm>
#include <cmath>

namespace jostle::client {
namespace {

constexpr std::int64_t rendering_timeout_us = 1'000'000;
constexpr double extrapolation_max_us = 50'000;  // as InterpolationBuffer

}  // namespace

v1::ViewTime rendered_time(const NewestFrame& newest, std::int64_t render_time_us, double tick_us) {
    v1::ViewTime moment;
    moment.set_tick(newest.frame);
    if (render_time_us == 0 || render_time_us < newest.due_us - rendering_timeout_us ||
        tick_us <= 0)
        return moment;
    const double after_us =
        std::min(static_cast<double>(render_time_us - newest.due_us), extrapolation_max_us);
    const double tick = std::max(1.0, newest.frame + after_us / tick_us);
    moment.set_tick(static_cast<std::uint32_t>(tick));
    moment.set_fraction(static_cast<float>(tick - std::floor(tick)));
    return moment;
}

}  // namespace jostle::client
