// SPDX-License-Identifier: MIT
//
// What a snapshot is told against.
#pragma once

#include <cstddef>

#include "jostle/snapshot/entity_state.h"

namespace jostle::wire {

// The frames that a snapshot refers to. Without base it is absolute: it has all entities in full.
// baseline2 and baseline3 sharpen the prediction; baseline2 needs base, baseline3 needs baseline2.
// Their frame numbers fall, each by 1 to 255: frame > base > baseline2 > baseline3.
struct Baselines {
    const QuantizedFrame* baseline = nullptr;
    const QuantizedFrame* baseline2 = nullptr;
    const QuantizedFrame* baseline3 = nullptr;
};

// Positions from `begin` to before `end`, in a frame and its base alike: the same entities, which
// lie at rest in the base and are in the frame what they are there.
struct UnchangedRun {
    std::size_t begin = 0, end = 0;
};

}  // namespace jostle::wire
