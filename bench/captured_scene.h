// SPDX-License-Identifier: MIT
//
// A scene of the catalogue as the frames that clients would get of it, one a tick: what codecs are
// measured on and trained with.
#pragma once

#include <string>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/snapshot/entity_state.h"

namespace jostle::bench {

struct CapturedScene {
    std::vector<wire::QuantizedFrame> frames;  // 1, 2, ...
    double hz = 60;
    double quantize_ns_per_body = 0;
};

// An error names the scene and what there is instead, or why its world stopped.
Result<CapturedScene> capture_scene(const std::string& name, double seconds,
                                    const wire::QuantSpec& spec);

// Bodies of `now` whose pose differs from that in `base`, which has the same bodies.
std::size_t count_moving(const wire::QuantizedFrame& now, const wire::QuantizedFrame& base);

}  // namespace jostle::bench
