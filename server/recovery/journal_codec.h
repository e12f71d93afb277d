// SPDX-License-Identifier: MIT
//
// Encodes the commands of a range of ticks. With the world before these ticks, they reproduce the
// world after them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "jostle/base/result.h"
#include "server/world/command.h"

namespace jostle::server {

struct TickRange {
    std::uint32_t first = 0, last = 0;

    bool operator==(const TickRange&) const = default;
};

// In tick `tick` the world was rewound to its state after the earlier tick `to`.
struct Rewind {
    std::uint32_t tick = 0, to = 0;

    bool operator==(const Rewind&) const = default;
};

// In tick `tick` the world was replaced by its state after the previous tick without the inputs of
// `client` from tick `first_tick` on (recover_world.h, OmittedInputs).
struct Undo {
    std::uint32_t tick = 0, first_tick = 0;
    std::uint32_t client = 0;

    bool operator==(const Undo&) const = default;
};

struct JournalSegment {
    // In ascending order; ticks without commands are omitted.
    std::vector<JournaledTick> ticks;
    // In ascending order: ticks in which the world was not stepped, for example while paused.
    std::vector<TickRange> paused_ticks;
    // If one of them is set, the segment contains nothing else.
    std::optional<Rewind> rewind = {};
    std::optional<Undo> undo = {};
};

std::string encode_journal(const JournalSegment& segment);
// corrupt_data: the bytes are not a journal segment.
Result<JournalSegment> decode_journal(std::string_view bytes);

}  // namespace jostle::server
