// SPDX-License-Identifier: MIT
//
// Channels: what modules tell clients with a frame (WIRE.md, "Channels"). Lists of whole numbers,
// of which a snapshot carries how they differ from those of its base. Frames share the lists that
// did not change. Any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "jostle/base/result.h"

namespace jostle::wire {

inline constexpr std::uint32_t channel_kinds_max = 64;
inline constexpr std::size_t channels_max = 4096;             // of a frame
inline constexpr std::size_t channel_values_max = 16 * 1024;  // of a channel
inline constexpr std::size_t frame_values_max = 256 * 1024;   // of all channels of a frame

using ChannelValues = std::shared_ptr<const std::vector<std::int32_t>>;

struct Channel {
    std::uint32_t kind = 0;    // below channel_kinds_max
    std::uint32_t entity = 0;  // 0: none
    ChannelValues values;      // never null
};

// In rising order of kind and entity, each once.
using Channels = std::vector<Channel>;

struct PackedChannels {
    std::vector<std::byte> bytes;  // empty: they are those of the base
    std::uint32_t crc = 0;         // of what the bytes tell
};

// `kinds`: bit k of it lets channels of kind k through, in `base` as in `now`.
PackedChannels encode_channels(const Channels& now, const Channels& baseline, std::uint64_t kinds);

// The channels of a frame, from those of its base, and the CRC of what the bytes told. The bytes
// are foreign: an error (corrupt_data) says what is wrong with them.
struct DecodedChannels {
    Channels channels;
    std::uint32_t crc = 0;
};
Result<DecodedChannels> read_channels(std::span<const std::byte> bytes, const Channels& baseline);
// The same, where the CRC must be that.
Result<Channels> decode_channels(std::span<const std::byte> bytes, std::uint32_t crc,
                                 const Channels& baseline);

}  // namespace jostle::wire
