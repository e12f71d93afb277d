// SPDX-License-Identifier: MIT
//
// Checksum in the header of a saved world. It detects accidental corruption; the loader handles
// forged data.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "physics/src/foundation/byte_stream.h"
#include "physics/src/foundation/hash.h"

namespace jostle::physics {

// Reads eight bytes as little endian; bytes past the end are zero.
inline std::uint64_t word_at(std::span<const std::byte> bytes, std::size_t at) {
    std::uint64_t word = 0;
    for (std::size_t k = 0; k < sizeof word && at + k < bytes.size(); k++)
        word |= std::to_integer<std::uint64_t>(bytes[at + k]) << (8 * k);
    return word;
}

// For versions up to 16: one chain of words, each of which depends on the previous one.
inline std::uint64_t chained_checksum(std::span<const std::byte> bytes) {
    Hasher hasher;
    hasher.add(bytes.size());
    for (std::size_t at = 0; at < bytes.size(); at += 8) hasher.add(word_at(bytes, at));
    return hasher.value;
}

// Since version 17: word k goes to chain k % 4, and the four chains are combined at the end, so
// that a processor computes them in parallel.
inline std::uint64_t checksum(std::span<const std::byte> bytes) {
    Hasher a, b, c, d;
    std::size_t at = 0;
    for (; bytes.size() - at >= 32; at += 32) {
        const std::byte* words = bytes.data() + at;
        a.add(get_bits<std::uint64_t>(words));
        b.add(get_bits<std::uint64_t>(words + 8));
        c.add(get_bits<std::uint64_t>(words + 16));
        d.add(get_bits<std::uint64_t>(words + 24));
    }
    for (Hasher* chain : {&a, &b, &c, &d}) {
        if (at < bytes.size()) chain->add(word_at(bytes, at));
        at += 8;
    }
    Hasher all;
    all.add(bytes.size());
    for (const Hasher* chain : {&a, &b, &c, &d}) all.add(chain->value);
    return all.value;
}

inline std::uint64_t checksum_of_version(std::uint32_t version, std::span<const std::byte> bytes) {
    return version < 17 ? chained_checksum(bytes) : checksum(bytes);
}

}  // namespace jostle::physics
