// SPDX-License-Identifier: MIT
//
// An in-memory copy of one stored world, for readers that would block the storage for too long.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "server/storage/world_storage.h"

namespace jostle::server {

class WorldStorageCopy : public WorldStorage {
public:
    // Copies the world, its checkpoints up to `last_checkpoint` (newest first, at most
    // `checkpoints_max`), and the journal after the oldest of them up to `last_tick`.
    static Result<std::unique_ptr<WorldStorageCopy>> of(WorldStorage& storage,
                                                        const std::string& id,
                                                        std::size_t checkpoints_max,
                                                        std::uint32_t last_checkpoint = 0xffffffff,
                                                        std::uint32_t last_tick = 0xffffffff);

    // Copies the world without checkpoints, and the journal after `sequence`.
    static Result<std::unique_ptr<WorldStorageCopy>> journal_of(WorldStorage& storage,
                                                                const std::string& id,
                                                                std::uint64_t sequence);
    // The checkpoint is newer than the others, in order of calls.
    void add(Checkpoint checkpoint);

    Status write(std::span<const StorageChange> changes) override;  // always returns unavailable
    Result<std::vector<StoredWorld>> worlds() override { return std::vector{world_}; }
    Result<std::vector<std::uint32_t>> checkpoint_ticks(const std::string& world) override;
    Result<Checkpoint> checkpoint(const std::string& world, std::uint32_t tick) override;
    Result<std::vector<JournalEntry>> entries(const std::string& world, std::uint64_t after,
                                              std::size_t bytes_max) override;
    Result<std::optional<std::string>> note(const std::string& name) override;

private:
    Status copy_world(WorldStorage& storage, const std::string& id);
    void copy_entries(WorldStorage& storage, std::uint64_t after, std::uint32_t last_tick);

    StoredWorld world_;
    std::vector<Checkpoint> checkpoints_;  // newest first
    std::vector<JournalEntry> entries_;    // in order of sequence
    Status damage_;                        // why the entries after them could not be read
};

}  // namespace jostle::server
