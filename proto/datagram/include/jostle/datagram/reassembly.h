// SPDX-License-Identifier: MIT
//
// Puts messages together from their parts, in whatever order they come. It holds the newest few
// unfinished messages, so a lost part costs its message and a bounded piece of memory: 300 kB at
// most. One thread at a time.
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

    // The whole message when this was its last missing part. Parts of messages that are older than
    // all that it holds, or that do not fit to their siblings, are dropped.
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

    std::vector<PartialMessage> partial_;  // the newest number last
    std::optional<std::uint32_t> done_;    // the newest that was finished
};

}  // namespace jostle::datagram
