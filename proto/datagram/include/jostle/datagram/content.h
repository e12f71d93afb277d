// SPDX-License-Identifier: MIT
//
// What is in a packet (WIRE.md, "Datagrams"): a message, a part of one that is too large for a
// packet, a question whether somebody is there, or its answer. Pure functions; any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/datagram/packet.h"

namespace jostle::datagram {

// Of a message; a larger one goes by the stream.
inline constexpr std::size_t fragments_max = 64;
// Each part has so many bytes but the last, which has at least one.
inline constexpr std::size_t fragment_bytes = content_bytes_max - 7;
inline constexpr std::size_t message_bytes_max = content_bytes_max - 1;  // in one packet

struct Message {
    std::string_view bytes;
};
struct Fragment {
    std::uint32_t message = 0;  // its number; rises
    std::uint8_t index = 0, count = 0;
    std::string_view bytes;
};
// Who answers has that address and the key.
struct PathChallenge {
    std::uint64_t token = 0;
};
struct PathResponse {
    std::uint64_t token = 0;
};
using Content = std::variant<Message, Fragment, PathChallenge, PathResponse>;

// Views into `content`. corrupt_data: it is none of these; the error says why.
Result<Content> decode_content(std::string_view content);

std::string encode(const PathChallenge& question);
std::string encode(const PathResponse& answer);
// A message, given in pieces, as the contents of one packet or several. Empty: it needs more than
// fragments_max.
std::vector<std::string> encode_message(std::span<const std::string_view> pieces,
                                        std::uint32_t number);

}  // namespace jostle::datagram
