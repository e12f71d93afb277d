// SPDX-License-Identifier: MIT
//
// Encodes channels: the state that modules publish with a frame (WIRE.md, "Channels"). Channels are
// lists of integers; a snapshot contains the differences from the channels of its baseline. Frames
// share unchanged lists. Any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "jostle/base/result.h"

namespace jostle::snapshot {

inline constexpr std::uint32_t channel_kinds_max = 64;
inline constexpr std::size_t channels_max = 4096;             ///< per frame
inline constexpr std::size_t channel_values_max = 16 * 1024;  ///< per channel
inline constexpr std::size_t frame_values_max = 256 * 1024;   ///< in all channels of a frame

using ChannelValues = std::shared_ptr<const std::vector<std::int32_t>>;

struct Channel {
    std::uint32_t kind = 0;    ///< below channel_kinds_max
    std::uint32_t entity = 0;  ///< 0: none
    ChannelValues values;      ///< never null
};

/// Sorted by kind, then entity; each pair occurs once.
using Channels = std::vector<Channel>;

struct PackedChannels {
    std::vector<std::byte> bytes;  ///< empty: same as the baseline
    std::uint32_t crc = 0;         ///< of the encoded changes
};

/// Encodes `now` against `baseline`. Bit k of `kinds` selects the channels of kind k in both lists.
PackedChannels encode_channels(const Channels& now, const Channels& baseline, std::uint64_t kinds);

/// The channels of a frame and the CRC of the decoded changes. The bytes are untrusted;
/// read_channels returns corrupt_data with the reason if they are malformed.
struct DecodedChannels {
    Channels channels;
    std::uint32_t crc = 0;
};
Result<DecodedChannels> read_channels(std::span<const std::byte> bytes, const Channels& baseline);
/// Like read_channels, and checks that the CRC of the changes is `crc`.
Result<Channels> decode_channels(std::span<const std::byte> bytes, std::uint32_t crc,
                                 const Channels& baseline);

}  // namespace jostle::snapshot
