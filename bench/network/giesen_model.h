// SPDX-License-Identifier: MIT
//
// A reference for Jostle's codecs: the model that Fabian Giesen published in 2015 for Glenn
// Fiedler's data set of 901 cubes (github.com/rygorous/gaffer_net, last version: 445 bytes per
// frame for that data set), reimplemented from his program. Its models continue from those of the
// base, so each chain of bases has its own state; a server would store one per client that skips
// frames.
//
// An adaptive binary arithmetic coder codes values relative to one base: whether the rotation
// changed, which component is largest, the differences of the three others in contexts of their
// last magnitude, whether the position changed, the difference of its step from the last one, and
// whether the cube is awake.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "jostle/snapshot/entity_state.h"

namespace jostle::bench {

class GiesenCoder {
public:
    // State after a frame, required for the next frame in its chain. Null: the start of a chain.
    struct State;
    using StatePtr = std::shared_ptr<const State>;

    // Both frames must contain the same entities. `player` is an index in the frame; cubes near it
    // have separate contexts. `m` is the maximum of a rotation component.
    GiesenCoder(std::size_t player, std::int32_t m) : player_(player), m_(m) {}

    struct Coded {
        std::vector<std::byte> bytes;
        StatePtr state;
    };
    Coded encode(const snapshot::QuantizedFrame& now, const snapshot::QuantizedFrame& baseline,
                 const StatePtr& baseline_state) const;

private:
    std::size_t player_;
    std::int32_t m_;
};

}  // namespace jostle::bench
