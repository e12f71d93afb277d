// SPDX-License-Identifier: MIT
//
// Shapes that are too large to be told with every body that has them: each made into bytes once,
// under an id that is a hash of its content, and told once to each client. Owned by a
// BroadcastCache, under its lock. What is kept grows with the different large shapes of a world,
// which come from its scene alone: what clients spawn is small.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "jostle/physics/geometry.h"
#include "server/replication/snapshot_cache.h"

namespace jostle::server {

// Of one message: far below the 4 MiB that clients take by default, and little enough that what
// waits behind it does not wait long.
inline constexpr std::size_t chunk_bytes_max = 256 * 1024;

struct LargeGeometry {
    std::uint64_t id = 0;
    std::vector<SharedBytes> messages;  // one GeometryChunk each
};

class GeometryTable {
public:
    // Null: small, to be told with the body. The same pointer for the same content.
    std::shared_ptr<const LargeGeometry> find_or_add(const physics::Geometry& geometry);

private:
    std::shared_ptr<const LargeGeometry> find_or_add(std::string bytes);

    struct Known {
        physics::Geometry held;  // so that no other shape can have its address
        std::shared_ptr<const LargeGeometry> geometry;
    };
    std::map<const void*, Known> by_address_;
    struct Content {
        std::string bytes;
        std::shared_ptr<const LargeGeometry> geometry;
    };
    std::map<std::uint64_t, Content> by_id_;
};

}  // namespace jostle::server
