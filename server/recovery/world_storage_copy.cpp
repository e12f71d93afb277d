// SPDX-License-Identifier: MIT
#include "server/recovery/world_storage_copy.h"

#include <algorithm>
#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {

Result<std::unique_ptr<WorldStorageCopy>> WorldStorageCopy::of(WorldStorage& storage,
                                                               const std::string& id,
                                                               std::size_t checkpoints_max,
                                                               std::uint32_t last_tick) {
    constexpr std::size_t bytes_at_once = 8 << 20;
    auto copy = std::make_unique<WorldStorageCopy>();
    const Result<std::vector<StoredWorld>> all = storage.worlds();
    if (!all.ok()) return all.error();
    const auto at = std::ranges::find(*all, id, &StoredWorld::id);
    if (at == all->end()) return Error{ErrorCode::not_found, "world " + id + " is not persisted"};
    copy->world_ = *at;
    ASSERT(copy->world_.id == id);
    const Result<std::vector<std::uint32_t>> ticks = storage.checkpoint_ticks(id);
    if (!ticks.ok()) return ticks.error();
    for (const std::uint32_t tick : *ticks) {
        if (tick > last_tick || copy->checkpoints_.size() >= checkpoints_max) continue;
        Result<Checkpoint> found = storage.checkpoint(id, tick);
        if (found.ok()) copy->checkpoints_.push_back(*std::move(found));
    }
    if (copy->checkpoints_.empty())
        return Error{ErrorCode::not_found, "world " + id + " has no intact checkpoint"};
    const std::uint64_t first = copy->checkpoints_.back().sequence;
    std::uint64_t after = first == 0 ? 0 : first - 1;
    for (;;) {
        Result<std::vector<JournalEntry>> some = storage.entries(id, after, bytes_at_once);
        if (!some.ok()) {
            copy->damage_ = some.error();
            break;
        }
        if (some->empty()) break;
        after = some->back().sequence;
        const bool enough = some->back().last_tick >= last_tick;
        std::ranges::move(*some, std::back_inserter(copy->entries_));
        if (enough) break;
    }
    return copy;
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
