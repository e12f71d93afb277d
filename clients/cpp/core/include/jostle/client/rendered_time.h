// SPDX-License-Identifier: MIT
//
// Which moment of the world a client shows, for servers that judge what it aims at by what it saw
// (Aim.seen, CastRaysRequest.seen). The same in the browser (clients/web/src/rendered_time.ts).
#pragma once

#include <cstdint>

#include "jostle/v1/common.pb.h"

namespace jostle::client {

// A snapshot that was decoded: its frame, and when its tick was due on the server's clock.
struct NewestFrame {
    std::uint32_t frame = 0;  // 0: there is none
    std::int64_t due_us = 0;
};

// `render_time_us`: of RenderClock; 0, or more than a second before the newest frame: nobody draws,
// so what is known is the newest frame. Pictures go on for 50 ms after the newest frame, not
// longer.
v1::ViewTime rendered_time(const NewestFrame& newest, std::int64_t render_time_us, double tick_us);

}  // namespace jostle::client
