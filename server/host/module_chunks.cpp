// SPDX-License-Identifier: MIT
#include "host/module_chunks.h"

#include <algorithm>
#include <utility>

#include "jostle/physics/world.h"

namespace jostle::server {

void ModuleChunks::publish(const physics::World& world,
                           const physics::ChunkWriter::NameOf& name_of) {
    const std::vector<ModuleChunk> before = std::exchange(chunks_, {});
    newly_too_large_.clear();
    for (const std::string& tag : world.modules()) {
        physics::ChunkWriter writer(name_of);
        world.module(tag)->publish(world, writer);
        if (!writer.bytes().empty()) add(tag, std::move(writer.bytes()), before);
    }
}

void ModuleChunks::add(const std::string& tag, std::vector<std::byte> bytes,
                       const std::vector<ModuleChunk>& before) {
    if (bytes.size() > chunk_bytes_max) {
        if (told_.insert(tag).second) newly_too_large_.push_back({tag, bytes.size()});
        return;
    }
    const auto old = std::ranges::find(before, tag, &ModuleChunk::tag);
    if (old != before.end() && *old->bytes == bytes)
        chunks_.push_back(*old);
    else
        chunks_.push_back({tag, std::make_shared<const std::vector<std::byte>>(std::move(bytes))});
}

}  // namespace jostle::server
