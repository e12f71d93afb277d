// SPDX-License-Identifier: MIT
//
// The contents of a packet (WIRE.md, "Datagrams"): a message, a fragment of a message that is too
// large for one packet, a path challenge or a path response. Pure functions; any thread.
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

/// Maximum number of fragments of a message; a larger message must use the stream.
inline constexpr std::size_t fragments_max = 64;
/// Size of every fragment except the last one, which has at least one byte.
inline constexpr std::size_t fragment_bytes = content_bytes_max - 7;
/// of an unfragmented message
inline constexpr std::size_t message_bytes_max = content_bytes_max - 1;

struct Message {
    std::string_view bytes;
};
struct Fragment {
    std::uint32_t message = 0;  ///< message number; increases
    std::uint8_t index = 0, count = 0;
    std::string_view bytes;
};
/// Proves that the sender of the response has the address and the key.
struct PathChallenge {
    std::uint64_t token = 0;
};
struct PathResponse {
    std::uint64_t token = 0;
};
using Content = std::variant<Message, Fragment, PathChallenge, PathResponse>;

/// Decodes the content of a packet. The result contains views into `content`. Returns corrupt_data
/// if the content is malformed; the message describes the fault.
Result<Content> decode_content(std::string_view content);

std::string encode(const PathChallenge& question);
std::string encode(const PathResponse& answer);
/// Encodes a message, given in pieces, as the contents of one or more packets. Returns an empty
/// list if the message needs more than fragments_max fragments.
std::vector<std::string> encode_message(std::span<const std::string_view> pieces,
                                        std::uint32_t number);

}  // namespace jostle::datagram
