// SPDX-License-Identifier: MIT
//
// The world time that a client renders, for lag compensation (Aim.view_time,
// CastRaysRequest.view_time). The web SDK has the same function
// (clients/web/sdk/src/interpolation/rendered_time.ts).
#pragma once

#include <cstdint>

#include "jostle/v1/common.pb.h"

namespace jostle::client {

/// The newest decoded snapshot: its frame, and the due time of its tick on the server's clock.
struct NewestFrame {
    std::uint32_t frame = 0;  ///< 0: none
    std::int64_t due_us = 0;
};

/// Returns the view time. `render_time_us`: of RenderClock. If it is 0 or more than 1 s before the
/// newest frame, the client does not render, and the result is the newest frame. Rendering
/// extrapolates at most 50 ms beyond the newest frame.
v1::ViewTime rendered_time(const NewestFrame& newest, std::int64_t render_time_us, double tick_us);

}  // namespace jostle::client
