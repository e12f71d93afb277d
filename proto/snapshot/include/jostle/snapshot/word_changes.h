// SPDX-License-Identifier: MIT
//
// Delta encoding of a list of words against the previous list (WIRE.md, "Controlled entity").
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "jostle/base/result.h"

namespace jostle::snapshot {

struct WordChanges {
    std::string changed;  ///< one bit per word, lowest bit first; trailing zero bytes are omitted
    std::string values;   ///< the changed words, 4 bytes each, little-endian
};

inline constexpr std::size_t words_max = 16 * 1024;  ///< maximum length of a list

/// Encodes the differences. Words that `before` does not have count as 0.
WordChanges changes_between(std::span<const std::uint32_t> before,
                            std::span<const std::uint32_t> now);
/// Returns the list of `size` words. Returns corrupt_data if the list is too long or the untrusted
/// bytes are inconsistent.
Result<std::vector<std::uint32_t>> apply_changes(std::span<const std::uint32_t> before,
                                                 std::size_t size, std::string_view changed,
                                                 std::string_view values);

}  // namespace jostle::snapshot
