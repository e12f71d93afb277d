// SPDX-License-Identifier: MIT
//
// What was done to a world in some ticks, as bytes: with the world as it was before, enough to have
// the world as it was after.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "jostle/base/result.h"
#include "server/world/journaled_command.h"

namespace jostle::server {

struct TickRange {
    std::uint32_t first = 0, last = 0;

    bool operator==(const TickRange&) const = default;
};

// In that tick the world became what it was after an earlier one.
struct Rewind {
    std::uint32_t tick = 0, to = 0;

    bool operator==(const Rewind&) const = default;
};

struct JournalSegment {
    // In rising order; those in which nothing was done are left out.
    std::vector<JournaledTick> ticks;
    // In rising order: the world was not stepped in them, as when it is paused.
    std::vector<TickRange> paused_ticks;
    // Then it is all that the batch has.
    std::optional<Rewind> rewind = {};
};

std::string encode_journal(const JournalSegment& batch);
// corrupt_data: the bytes are no such batch.
Result<JournalSegment> decode_journal(std::string_view bytes);

}  // namespace jostle::server
