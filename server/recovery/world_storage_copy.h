// SPDX-License-Identifier: MIT
//
// What a store has of one world, in memory: for who wants to look at it for longer than the store
// can be held up.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "server/storage/world_storage.h"

namespace jostle::server {

class WorldStorageCopy : public WorldStorage {
public:
    // The world, its checkpoints up to that tick, newest first and at most so many, and what came
    // after the oldest of them.
    static Result<std::unique_ptr<WorldStorageCopy>> of(WorldStorage& store, const std::string& id,
                                                        std::size_t checkpoints_max,
                                                        std::uint32_t last_tick = 0xffffffff);

    Status write(std::span<const StorageChange> changes) override;  // unavailable
    Result<std::vector<StoredWorld>> worlds() override { return std::vector{world_}; }
    Result<std::vector<std::uint32_t>> checkpoint_ticks(const std::string& world) override;
    Result<Checkpoint> checkpoint(const std::string& world, std::uint32_t tick) override;
    Result<std::vector<JournalEntry>> entries(const std::string& world, std::uint64_t after,
                                              std::size_t bytes_max) override;
    Result<std::optional<std::string>> note(const std::string& name) override;

private:
    StoredWorld world_;
    std::vector<Checkpoint> checkpoints_;  // newest first
    std::vector<JournalEntry> entries_;    // in order
    Status damage_;                        // what came after them could not be read
};

}  // namespace jostle::server
