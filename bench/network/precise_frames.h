// SPDX-License-Identifier: MIT
//
// The snapshots of a scene in a guaranteed precision, as a client receives them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/snapshot/precision.h"

namespace jostle::bench {

struct PreciseFrames {
    std::string scene;
    double updates_hz = 30;
    double settle_seconds = 5;  // simulated before the first measured frame
    double seconds = 60;        // measured
    snapshot::Precision precision;
};

struct PreciseResult {
    std::vector<double> bytes;  // of each frame
    double moving = 0;          // bodies per frame whose pose differs from the previous frame
    double position_error_m = 0, rotation_error_rad = 0;  // greatest, of all decoded poses
    double encode_us = 0, decode_us = 0;                  // CPU time per frame
};

// Errors: not_found for an unknown scene, corrupt_data if a decoded frame differs from the encoded
// one or a decoded pose exceeds the precision.
Result<PreciseResult> measure_precise_frames(const PreciseFrames& settings);

}  // namespace jostle::bench
