// SPDX-License-Identifier: MIT
#include "jostle/client/rendered_time.h"

#include <algorithm>
#include <cmath>

namespace jostle::client {
namespace {

constexpr std::int64_t not_drawn_us = 1'000'000;
constexpr double shown_after_us = 50'000;  // as InterpolationBuffer

}  // namespace

v1::ViewTime rendered_time(const NewestFrame& newest, std::int64_t shown_us, double tick_us) {
    v1::ViewTime moment;
    moment.set_tick(newest.frame);
    if (shown_us == 0 || shown_us < newest.due_us - not_drawn_us || tick_us <= 0) return moment;
    const double after_us = std::min(static_cast<double>(shown_us - newest.due_us), shown_after_us);
    const double tick = std::max(1.0, newest.frame + after_us / tick_us);
    moment.set_tick(static_cast<std::uint32_t>(tick));
    moment.set_fraction(static_cast<float>(tick - std::floor(tick)));
    return moment;
}

}  // namespace jostle::client
