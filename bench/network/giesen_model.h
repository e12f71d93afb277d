// SPDX-License-Identifier: MIT
//
// What Jostle's codecs are compared with: the model that Fabian Giesen published in 2015 for Glenn
// Fiedler's data set of 901 cubes (github.com/rygorous/gaffer_net, its last version: 445 bytes a
// frame there), written anew from his program. Its models go on from those of the base, so each
// chain of bases has a state of its own; a server would keep one for each client that skips.
//
// Values are coded by an adaptive binary arithmetic coder against the base alone: whether the
// rotation changed, which component is largest, differences of the three others in contexts of how
// large they were the last time, whether the position changed, how its step differs from the last
// one, and whether the cube is awake.
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
    // Of one frame after it was coded: what the next one in its chain needs. Null: nothing yet.
    struct State;
    using StatePtr = std::shared_ptr<const State>;

    // The entities are the same in both; cubes that are near to `player`, a position in the frame,
    // have contexts of their own. `m` is the largest component of a rotation.
    GiesenCoder(std::size_t player, std::int32_t m) : player_(player), m_(m) {}

    struct Coded {
        std::vector<std::byte> bytes;
        StatePtr state;
    };
    Coded encode(const wire::QuantizedFrame& now, const wire::QuantizedFrame& baseline,
                 const StatePtr& baseline_state) const;

private:
    std::size_t player_;
    std::int32_t m_;
};

}  // namespace jostle::bench
