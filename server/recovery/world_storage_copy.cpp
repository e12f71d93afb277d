// SPDX-License-Identifier: MIT
#include "server/recovery/world_storage_copy.h"

#include <algorithm>
#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {

Result<std::unique_ptr<WorldStorageCopy>> WorldStorageCopy::of(WorldStorage& storage,
                                                               const std::string& id,
                                                               std::size_t checkpoints_max,
                                                               std::uint32_t last_checkpoint,
                                                               std::uint32_t last_tick) {
    auto copy = std::make_unique<WorldStorageCopy>();
    if (Status s = copy->copy_world(storage, id); !s.ok()) return s.error();
    const Result<std::vector<std::uint32_t>> ticks = storage.checkpoint_ticks(id);
    if (!ticks.ok()) return ticks.error();
    for (const std::uint32_t tick : *ticks) {
        if (tick > last_checkpoint || copy->checkpoints_.size() >= checkpoints_max) continue;
        Result<Checkpoint> found = storage.checkpoint(id, tick);
        if (found.ok()) copy->checkpoints_.push_back(*std::move(found));
    }
    if (copy->checkpoints_.empty())
        return Error{ErrorCode::not_found, "world " + id + " has no intact checkpoint"};
    const std::uint64_t first = copy->checkpoints_.back().sequence;
    copy->copy_entries(storage, first == 0 ? 0 : first - 1, last_tick);
    return copy;
}

Result<std::unique_ptr<WorldStorageCopy>> WorldStorageCopy::journal_of(WorldStorage& storage,
                                                                       const std::string& id,
                                                                       std::uint64_t sequence) {
    auto copy = std::make_unique<WorldStorageCopy>();
    if (Status s = copy->copy_world(storage, id); !s.ok()) return s.error();
    copy->copy_entries(storage, sequence, 0xffffffff);
    return copy;
}

Status WorldStorageCopy::copy_world(WorldStorage& storage, const std::string& id) {
    const Result<std::vector<StoredWorld>> all = storage.worlds();
    if (!all.ok()) return all.error();
    const auto at = std::ranges::find(*all, id, &StoredWorld::id);
    if (at == all->end()) return Error{ErrorCode::not_found, "world " + id + " is not persisted"};
    world_ = *at;
    ASSERT(world_.id == id);
    return {};
}

void WorldStorageCopy::copy_entries(WorldStorage& storage, std::uint64_t after,
                                    std::uint32_t last_tick) {
    constexpr std::size_t bytes_at_once = 8 << 20;
    for (;;) {
        Result<std::vector<JournalEntry>> some = storage.entries(world_.id, after, bytes_at_once);
        if (!some.ok()) {
            damage_ = some.error();
            return;
        }
        if (some->empty()) return;
        after = some->back().sequence;
        const bool enough = some->back().last_tick >= last_tick;
        std::ranges::move(*some, std::back_inserter(entries_));
        if (enough) return;
    }
}

void WorldStorageCopy::add(Checkpoint checkpoint) {
    ASSERT(checkpoints_.empty() || checkpoints_.front().tick < checkpoint.tick);
    checkpoints_.insert(checkpoints_.begin(), std::move(checkpoint));
}

Status WorldStorageCopy::write(std::span<const StorageChange>) {
    return Error{ErrorCode::unavailable, "this storage is a read-only copy"};
}

Result<std::vector<std::uint32_t>> WorldStorageCopy::checkpoint_ticks(const std::string&) {
    std::vector<std::uint32_t> ticks;
    for (const Checkpoint& checkpoint : checkpoints_) ticks.push_back(checkpoint.tick);
    return ticks;
}

Result<Checkpoint> WorldStorageCopy::checkpoint(const std::string&, std::uint32_t tick) {
    const auto at = std::ranges::find(checkpoints_, tick, &Checkpoint::tick);
    if (at == checkpoints_.end())
        return Error{ErrorCode::not_found, "no checkpoint of tick " + std::to_string(tick)};
    return *at;
}

Result<std::vector<JournalEntry>> WorldStorageCopy::entries(const std::string&, std::uint64_t after,
                                                            std::size_t) {
    const auto begin = std::ranges::upper_bound(entries_, after, {}, &JournalEntry::sequence);
    if (begin == entries_.end() && !damage_.ok()) return damage_.error();
    return std::vector<JournalEntry>(begin, entries_.end());
}

Result<std::optional<std::string>> WorldStorageCopy::note(const std::string&) {
    return std::optional<std::string>();
}

}  // namespace jostle::server
