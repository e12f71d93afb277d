// SPDX-License-Identifier: MIT
//
// What a completion queue gives back: whose event it is. Play streams and calls share a queue.
#pragma once

#include <cstdint>

namespace jostle::server {

struct RpcTag {
    enum class Owner : std::uint8_t { play, call };

    explicit RpcTag(Owner owner) : owner(owner) {}

    const Owner owner;
};

}  // namespace jostle::server
