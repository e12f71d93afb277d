// SPDX-License-Identifier: MIT
//
// A list of words as what changed in it since the list before (WIRE.md, "Driven things").
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "jostle/base/result.h"

namespace jostle::wire {

struct WordChanges {
    std::string changed;  // a bit for each word, the lowest first; zeros at the end are left out
    std::string values;   // of these words, 4 bytes each, little-endian
};

inline constexpr std::size_t words_max = 16 * 1024;  // of a list

// Words that `before` does not have count as 0 there.
WordChanges changes_between(std::span<const std::uint32_t> before,
                            std::span<const std::uint32_t> now);
// The list of `size` words. corrupt_data: it is too long, or the bytes, which are foreign, do not
// belong together.
Result<std::vector<std::uint32_t>> apply_changes(std::span<const std::uint32_t> before,
                                                 std::size_t size, std::string_view changed,
                                                 std::string_view values);

}  // namespace jostle::wire
