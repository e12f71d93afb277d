// SPDX-License-Identifier: MIT
#include "server/messages/geometry_table.h"

#include <utility>

#include "jostle/base/check.h"
#include "jostle/scenes/geometry_message_bytes.h"
#include "jostle/scenes/shape_message.h"
#include "jostle/v1/play.pb.h"
#include "server/messages/server_message.h"

namespace jostle::server {

namespace {

// FNV-1a (Fowler, Noll, Vo), 64 bits. Shapes with the same hash get different ids (below).
std::uint64_t hash_of(const std::string& bytes) {
    std::uint64_t hash = 0xcbf29ce484222325ull;
    for (const char c : bytes) {
        hash ^= static_cast<unsigned char>(c);
        hash *= 0x100000001b3ull;
    }
    return hash;
}

std::vector<SharedBytes> chunks_of(std::uint64_t id, const std::string& bytes) {
    const std::size_t chunk_count = (bytes.size() + chunk_bytes_max - 1) / chunk_bytes_max;
    std::vector<SharedBytes> messages;
    for (std::size_t chunk = 0; chunk < chunk_count; chunk++)
        messages.push_back(std::make_shared<const std::string>(encode_geometry_chunk(
            {.id = id,
             .chunk = static_cast<std::uint32_t>(chunk),
             .chunk_count = static_cast<std::uint32_t>(chunk_count),
             .data = std::string_view(bytes).substr(chunk * chunk_bytes_max, chunk_bytes_max)})));
    return messages;
}

}  // namespace

std::shared_ptr<const LargeGeometry> GeometryTable::find_or_add(const physics::Geometry& geometry) {
    if (scenes::geometry_message_bytes(geometry) <= scenes::inline_geometry_bytes_max)
        return nullptr;
    const void* address = scenes::shared_data(geometry);
    if (const auto known = by_address_.find(address); known != by_address_.end())
        return known->second.geometry;
    v1::Shape shape;
    scenes::write_geometry(shape, geometry, {});
    std::shared_ptr<const LargeGeometry> made = find_or_add(shape.SerializeAsString());
    ASSERT(address && made);
    by_address_.emplace(address, Known{geometry, made});
    return made;
}

// Contents with the same hash get consecutive ids, so that a shape crafted to collide never
// replaces another one.
std::shared_ptr<const LargeGeometry> GeometryTable::find_or_add(std::string bytes) {
    ASSERT(!bytes.empty());
    std::uint64_t id = hash_of(bytes);
    for (auto known = by_id_.find(id); known != by_id_.end(); known = by_id_.find(++id))
        if (known->second.bytes == bytes) return known->second.geometry;
    auto made = std::make_shared<const LargeGeometry>(LargeGeometry{id, chunks_of(id, bytes)});
    by_id_.emplace(id, Content{std::move(bytes), made});
    return made;
}

}  // namespace jostle::server
