// SPDX-License-Identifier: MIT
//
// Measures one row of the speed table.
#pragma once

#include "bench/speed/engine_kinds.h"
#include "bench/speed/speed_row.h"
#include "bench/speed/speed_scenes.h"

namespace jostle::bench {

struct RowRequest {
    const SpeedScene* scene = nullptr;
    const EngineKind* engine = nullptr;  // must be built in
    int threads = 1;
    int steps = 0;  // 0: the scene's default
    bool sleep = false;
    bool accuracy = true;
};

// Times only the steps of the scene. Accuracy is checked in a second run of the same steps, because
// the check would change the content of the caches. The row records whether both runs end in the
// same poses.
SpeedRow measure_row(const RowRequest& request);

// The same in a child process.
SpeedRow measure_row_in_child(const RowRequest& request);

}  // namespace jostle::bench
