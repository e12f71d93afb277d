// SPDX-License-Identifier: MIT
//
// Asks for a record that will soon be read, when records lie where no hardware foresees it.
#pragma once

#include <cstddef>

namespace jostle::physics {

// The lines of the record from byte `begin` to byte `end`.
template <class Record>
void prefetch(const Record& record, std::size_t begin = 0, std::size_t end = sizeof(Record)) {
    const char* at = reinterpret_cast<const char*>(&record);
    for (std::size_t offset = begin; offset < end; offset += 64) __builtin_prefetch(at + offset);
    asm volatile("");  // or GCC takes functions that do only this for idle and drops their calls
}

}  // namespace jostle::physics
