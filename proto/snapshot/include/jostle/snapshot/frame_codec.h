// SPDX-License-Identifier: MIT
//
// A frame against up to three earlier ones. WIRE.md describes the bytes of both codecs, so that a
// stranger can write another. What is predicted and what is learned follows from the bases and the
// frame alone, never from hidden state, so one encoding serves every client that holds the same
// bases. Any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/snapshot/baselines.h"

namespace jostle::wire {

// By their numbers in Hello and Welcome.
enum class Codec : std::uint32_t {
    bits = 1,   // every client understands it
    range = 2,  // two thirds of the bytes, about twice the time
};
inline constexpr Codec newest_codec = Codec::range;

// `quiet`: what need not be looked at, rising runs, given only where frame and base are of the same
// entities. The bytes are the same with and without.
std::vector<std::byte> encode_frame(const QuantizedFrame& frame, const Baselines& baselines,
                                    const QuantSpec& spec, Codec codec = Codec::bits,
                                    std::span<const UnchangedRun> unchanged = {});

// What a client is willing to hold unless it says otherwise.
inline constexpr std::size_t default_entities_max = 1u << 20;

// Foreign bytes: every read is bounded. An error (corrupt_data) says what was wrong and where.
// `max_entities` bounds the memory that bytes can make us take.
Result<QuantizedFrame> decode_frame(std::uint32_t frame_number, std::span<const std::byte> packed,
                                    const Baselines& baselines, const QuantSpec& spec,
                                    std::size_t max_entities = default_entities_max,
                                    Codec codec = Codec::bits);

// CRC-32 (crc32.h) of the entities, each written as 24 bytes; WIRE.md gives their layout.
std::uint32_t frame_crc(const QuantizedFrame& frame);
// The same, for who knows which entities are as they were: block_crc() of each crc_block entities,
// as many whole blocks from the first on as are given.
inline constexpr std::size_t crc_block = 128;
std::uint32_t block_crc(std::span<const EntityState> block);
std::uint32_t frame_crc(const QuantizedFrame& frame, std::span<const std::uint32_t> blocks);

}  // namespace jostle::wire
