// SPDX-License-Identifier: MIT
//
// Reassembles messages from fragments that arrive in any order. It buffers only the newest few
// incomplete messages, so a lost fragment costs its message and a bounded amount of memory (at most
// 300 kB). One thread at a time.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "jostle/datagram/content.h"

namespace jostle::datagram {

class Reassembly {
public:
    static constexpr std::size_t partial_messages_max = 4;

    /// Adds a fragment. Returns the message if this was its last missing fragment. Drops fragments
    /// of messages older than all buffered ones, and fragments that are inconsistent with the
    /// others of their message.
    std::optional<std::string> add(const Fragment& part);
    std::size_t bytes_held() const;

private:
    struct PartialMessage {
        std::uint32_t number = 0;
        std::uint8_t count = 0;
        std::vector<std::string> parts;  // empty: missing
        std::size_t missing = 0;
    };
    PartialMessage* find_or_add(const Fragment& part);

    std::vector<PartialMessage> partial_;  // ascending numbers
    std::optional<std::uint32_t> done_;    // newest completed message
};

}  // namespace jostle::datagram
