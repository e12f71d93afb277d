// SPDX-License-Identifier: MIT
//
// Ids that cannot be guessed, for state that only the caller that created it may read. Any thread.
#pragma once

#include <unistd.h>

#include <string>

namespace jostle::server {

// 32 hexadecimal digits; empty if the system has no random numbers.
inline std::string random_id() {
    constexpr char digits[] = "0123456789abcdef";
    unsigned char bytes[16];
    if (::getentropy(bytes, sizeof bytes) != 0) return {};
    std::string id;
    for (const unsigned char byte : bytes) {
        id += digits[byte >> 4];
        id += digits[byte & 15];
    }
    return id;
}

}  // namespace jostle::server
