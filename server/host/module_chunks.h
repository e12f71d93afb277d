// SPDX-License-Identifier: MIT
//
// What the modules of a world tell clients, tick by tick. A chunk that says what it said before
// stays the same bytes, so that who compares frames compares pointers. Owned by HostedWorld; one
// thread.
#pragma once

#include <cstddef>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "host/command.h"
#include "jostle/physics/module.h"

namespace jostle::server {

// Each client gets each chunk that changed: a snapshot must not drown in one.
inline constexpr std::size_t chunk_bytes_max = 16 * 1024;

using ChunkBytes = std::shared_ptr<const std::vector<std::byte>>;

struct ModuleChunk {
    std::string tag;
    ChunkBytes bytes;  // in a frame never null, never empty
};

class ModuleChunks {
public:
    // After a step: asks each module. Chunks beyond chunk_bytes_max are left out.
    void publish(const physics::World& world, const physics::ChunkWriter::NameOf& name_of);
    // In the order of the modules.
    const std::vector<ModuleChunk>& chunks() const { return chunks_; }

    struct TooLarge {
        std::string tag;
        std::size_t bytes = 0;
    };
    // Whose chunk was left out by the last publish(), each module once.
    const std::vector<TooLarge>& newly_too_large() const { return newly_too_large_; }

private:
    void add(const std::string& tag, std::vector<std::byte> bytes,
             const std::vector<ModuleChunk>& before);

    std::vector<ModuleChunk> chunks_;
    std::vector<TooLarge> newly_too_large_;
    std::set<std::string> told_;  // of whom newly_too_large() told
};

}  // namespace jostle::server
