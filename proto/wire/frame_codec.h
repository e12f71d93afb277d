// SPDX-License-Identifier: MIT
//
// Codec 1: a frame against up to three earlier ones, in Rice and exponential Golomb codes of bits.
// WIRE.md describes the bytes, so that a stranger can write another codec. A body's prediction
// follows from the bases alone, never from hidden state, so one encoding serves every client that
// holds the same bases. Any thread.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "jostle/base/result.h"
#include "wire/entity_state.h"

namespace jostle::wire {

// The frames that a snapshot refers to. Without base it is absolute: it has all entities in full.
// base2 and base3 sharpen the prediction; base2 needs base, base3 needs base2. Their frame numbers
// fall, each by 1 to 255: frame > base > base2 > base3.
struct Bases {
    const QuantizedFrame* base = nullptr;
    const QuantizedFrame* base2 = nullptr;
    const QuantizedFrame* base3 = nullptr;
};

std::vector<std::byte> encode_frame(const QuantizedFrame& frame, const Bases& bases,
                                    const QuantSpec& spec);

// Foreign bytes: every read is bounded. An error (corrupt_data) says what was wrong and at which
// bit. `max_entities` bounds the memory that bytes can make us take.
Result<QuantizedFrame> decode_frame(std::uint32_t frame_number, std::span<const std::byte> packed,
                                    const Bases& bases, const QuantSpec& spec,
                                    std::size_t max_entities = 1u << 20);

// CRC-32 (crc32.h) of the entities, each written as 24 bytes; WIRE.md gives their layout.
std::uint32_t frame_crc(const QuantizedFrame& frame);

}  // namespace jostle::wire
