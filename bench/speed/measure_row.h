// SPDX-License-Identifier: MIT
//
// Fills one row of the speed table.
#pragma once

#include "bench/speed/engine_kinds.h"
#include "bench/speed/speed_row.h"
#include "bench/speed/speed_scenes.h"

namespace jostle::bench {

struct RowRequest {
    const SpeedScene* scene = nullptr;
    const EngineKind* engine = nullptr;  // built in
    int threads = 1;
    int steps = 0;  // 0: as many as the scene has
    bool sleep = false;
    bool accuracy = true;
};

// Times the scene's steps and nothing else. Accuracy is checked in a second run of the same steps,
// as that work would leave other data in the caches; that both runs end alike is checked.
SpeedRow measure_row(const RowRequest& request);

// The same in a child process.
SpeedRow measure_row_in_child(const RowRequest& request);

}  // namespace jostle::bench
