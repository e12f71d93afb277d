// SPDX-License-Identifier: MIT
//
// Codec 1: a frame against up to three earlier ones, bit-packed with fixed Rice codes. Writer and
// reader stand side by side; WIRE.md describes the bytes so that a stranger can write another. A
// body's prediction is a pure function of the bases, never of hidden state, so one encoding serves
// every client that holds the same bases.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "jostle/base/result.h"
#include "wire/entity_state.h"

namespace jostle::wire {

// The frames a snapshot refers to. base null: absolute. base2 and base3 sharpen the prediction;
// null: not used. Their frame numbers fall: frame > base > base2 > base3.
struct Bases {
    const QuantizedFrame* base = nullptr;
    const QuantizedFrame* base2 = nullptr;
    const QuantizedFrame* base3 = nullptr;
};

std::vector<std::byte> encode_frame(const QuantizedFrame& frame, const Bases& bases,
                                    const QuantSpec& spec);

// Foreign bytes: every read is bounded. An error says what was wrong and where. `max_entities`
// bounds the memory that bytes can make us take.
Result<QuantizedFrame> decode_frame(std::uint32_t frame_number, std::span<const std::byte> packed,
                                    const Bases& bases, const QuantSpec& spec,
                                    std::size_t max_entities = 1u << 20);

// CRC-32 (IEEE, reflected, as zlib) over the canonical little-endian form of the entities; WIRE.md
// gives the layout.
std::uint32_t frame_crc(const QuantizedFrame& frame);

}  // namespace jostle::wire
