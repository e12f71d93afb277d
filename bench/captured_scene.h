// SPDX-License-Identifier: MIT
//
// A scene of the catalogue as the frames that a client would receive, one per tick: the input for
// measuring and training codecs.
#pragma once

#include <string>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/scenes/scene.h"
#include "jostle/snapshot/entity_state.h"

namespace jostle::bench {

struct CapturedScene {
    std::vector<snapshot::QuantizedFrame> frames;  // numbered from 1
    double hz = 60;
    double quantize_ns_per_body = 0;
};

// A scene of the catalogue. Errors: not_found with the list of scenes.
Result<scenes::SceneDescription> find_scene_or_suggest(const std::string& name);

// Errors: not_found with the list of scenes, or the error that stopped the world.
Result<CapturedScene> capture_scene(const std::string& name, double seconds,
                                    const snapshot::QuantSpec& spec);

// Number of bodies in `now` whose pose differs from that in `base`, which has the same bodies.
std::size_t count_moving(const snapshot::QuantizedFrame& now, const snapshot::QuantizedFrame& base);

}  // namespace jostle::bench
