// SPDX-License-Identifier: MIT
//
// The baseline frames against which a snapshot is encoded.
#pragma once

#include <cstddef>

#include "jostle/snapshot/entity_state.h"

namespace jostle::snapshot {

/// The baselines of a snapshot. Without `baseline` the snapshot is absolute and contains all
/// entities. baseline2 and baseline3 improve the prediction; baseline2 requires baseline, baseline3
/// requires baseline2. Frame numbers descend, by 1 to 255 each: frame > baseline > baseline2 >
/// baseline3.
struct Baselines {
    const QuantizedFrame* baseline = nullptr;
    const QuantizedFrame* baseline2 = nullptr;
    const QuantizedFrame* baseline3 = nullptr;
};

/// The positions [begin, end) in a frame and in its baseline: the same entities, at rest in the
/// baseline and unchanged in the frame.
struct UnchangedRun {
    std::size_t begin = 0, end = 0;
};

}  // namespace jostle::snapshot
