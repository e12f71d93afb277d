// SPDX-License-Identifier: MIT
//
// Encodes a frame against up to three earlier frames. WIRE.md specifies the bytes of both codecs.
// Prediction and models depend only on the baselines and the frame, never on hidden state, so one
// encoding serves every client that has the same baselines. Any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/snapshot/baselines.h"

namespace jostle::snapshot {

/// Numbers as in Hello.codec and Welcome.codec.
enum class Codec : std::uint32_t {
    bits = 1,   ///< supported by every client
    range = 2,  ///< two thirds of the bytes, about twice the time
};
inline constexpr Codec newest_codec = Codec::range;

/// Encodes a frame. `unchanged` contains ascending runs of entities to skip; it is only allowed if
/// frame and baseline have the same entities. The bytes do not depend on it.
std::vector<std::byte> encode_frame(const QuantizedFrame& frame, const Baselines& baselines,
                                    const QuantSpec& spec, Codec codec = Codec::bits,
                                    std::span<const UnchangedRun> unchanged = {});

/// Default limit on the entities of a decoded frame.
inline constexpr std::size_t default_entities_max = 1u << 20;

/// Decodes untrusted bytes; every read is bounded. Returns corrupt_data with the cause and the
/// position. `max_entities` bounds the allocated memory.
Result<QuantizedFrame> decode_frame(std::uint32_t frame_number, std::span<const std::byte> packed,
                                    const Baselines& baselines, const QuantSpec& spec,
                                    std::size_t max_entities = default_entities_max,
                                    Codec codec = Codec::bits);

/// CRC-32 (crc32.h) of the entities, 24 bytes each; WIRE.md specifies the layout.
std::uint32_t frame_crc(const QuantizedFrame& frame);
/// Like frame_crc, with precomputed CRCs: block_crc() of each block of crc_block entities, for the
/// leading complete blocks.
inline constexpr std::size_t crc_block = 128;
std::uint32_t block_crc(std::span<const EntityState> block);
std::uint32_t frame_crc(const QuantizedFrame& frame, std::span<const std::uint32_t> blocks);

}  // namespace jostle::snapshot
