// SPDX-License-Identifier: MIT
//
// Software prefetch of a record, for access patterns that the hardware prefetcher does not detect.
#pragma once

#include <cstddef>

namespace jostle::physics {

// Prefetches the cache lines of the record from byte `begin` to byte `end`.
template <class Record>
void prefetch(const Record& record, std::size_t begin = 0, std::size_t end = sizeof(Record)) {
    const char* at = reinterpret_cast<const char*>(&record);
    for (std::size_t offset = begin; offset < end; offset += 64) __builtin_prefetch(at + offset);
    // GCC otherwise treats functions that only prefetch as pure and drops their calls.
    asm volatile("");
}

}  // namespace jostle::physics
