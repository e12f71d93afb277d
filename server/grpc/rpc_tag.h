// SPDX-License-Identifier: MIT
//
// Tag of a completion queue: identifies the owner of the event. Play streams and calls share a
// queue.
#pragma once

#include <cstdint>

namespace jostle::server {

struct RpcTag {
    enum class Owner : std::uint8_t { play, call };

    explicit RpcTag(Owner of) : owner(of) {}

    const Owner owner;
};

}  // namespace jostle::server
