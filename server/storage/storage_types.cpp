// SPDX-License-Identifier: MIT
#include "server/storage/storage_types.h"

namespace jostle::server {
namespace {

constexpr std::size_t row_bytes = 256;  // in addition to the strings

struct Size {
    std::size_t operator()(const PutWorld& c) const {
        const StoredWorld& w = c.world;
        return w.id.size() + w.name.size() + w.engine.size() + w.settings.size();
    }
    std::size_t operator()(const DropWorld& c) const { return c.id.size(); }
    std::size_t operator()(const AppendEntry& c) const {
        return c.world.size() + c.entry.data.size();
    }
    std::size_t operator()(const PutCheckpoint& c) const {
        return c.world.size() + c.checkpoint.exact.size() + c.checkpoint.portable.size();
    }
    std::size_t operator()(const Trim& c) const { return c.world.size(); }
    std::size_t operator()(const TruncateJournal& c) const { return c.world.size(); }
    std::size_t operator()(const PutNote& c) const { return c.name.size() + c.value.size(); }
};

}  // namespace

std::size_t bytes_of(const StorageChange& change) {
    return row_bytes + std::visit(Size{}, change);
}

}  // namespace jostle::server
