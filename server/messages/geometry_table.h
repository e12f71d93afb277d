// SPDX-License-Identifier: MIT
//
// Shapes that are too large to be sent with every body that uses them: each is encoded once, under
// an id that is a hash of its content, and sent once per client. Owned by a BroadcastCache, and
// guarded by its lock. The table grows with the number of distinct large shapes in a world; all of
// them come from its scene, because spawned shapes are small.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "jostle/physics/geometry.h"
#include "server/replication/snapshot_cache.h"

namespace jostle::server {

// Maximum bytes per message: far below the default client limit of 4 MiB, and small enough that
// later messages are not delayed for long.
inline constexpr std::size_t chunk_bytes_max = 256 * 1024;

struct LargeGeometry {
    std::uint64_t id = 0;
    std::vector<SharedBytes> messages;  // one GeometryChunk each
};

class GeometryTable {
public:
    // Returns null if the geometry is small and is sent with the body. Returns the same pointer for
    // the same content.
    std::shared_ptr<const LargeGeometry> find_or_add(const physics::Geometry& geometry);

private:
    std::shared_ptr<const LargeGeometry> find_or_add(std::string bytes);

    struct Known {
        physics::Geometry held;  // keeps the address from being reused by another shape
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
