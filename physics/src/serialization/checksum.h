// SPDX-License-Identifier: MIT
//
// The checksum in a saved world's header. It guards against accidents, not against forgers: those
// meet the loader.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "physics/src/foundation/byte_stream.h"
#include "physics/src/foundation/hash.h"

namespace jostle::physics {

// Eight bytes little endian; past the end zeros.
inline std::uint64_t word_at(std::span<const std::byte> bytes, std::size_t at) {
    std::uint64_t word = 0;
    for (std::size_t k = 0; k < sizeof word && at + k < bytes.size(); k++)
        word |= std::to_integer<std::uint64_t>(bytes[at + k]) << (8 * k);
    return word;
}

// Of versions up to 16: one chain of words, each of which waits for the one before.
inline std::uint64_t chained_checksum(std::span<const std::byte> bytes) {
    Hasher hasher;
    hasher.add(bytes.size());
    for (std::size_t at = 0; at < bytes.size(); at += 8) hasher.add(word_at(bytes, at));
    return hasher.value;
}

// Since version 17: word k goes to chain k % 4, and the four come together in the end. A processor
// works on all four at once.
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
