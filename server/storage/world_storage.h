// SPDX-License-Identifier: MIT
//
// Interface of the persistent storage of worlds. One process writes; one thread at a time calls.
//
// Errors: unavailable or resource_exhausted (the disk is missing, slow or full; the same call may
// succeed later), corrupt_data (the stored data was altered; the message names the row),
// already_exists and not_found (the change contradicts the stored data and can never succeed).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "jostle/base/result.h"
#include "server/storage/storage_types.h"

namespace jostle::server {

class WorldStorage {
public:
    virtual ~WorldStorage() = default;

    // Applies all changes or none; they are durable on return. Writing existing data again is not
    // an error, so that a caller that does not know the outcome can repeat the call.
    virtual Status write(std::span<const StorageChange> changes) = 0;

    virtual Result<std::vector<StoredWorld>> worlds() = 0;
    // Ticks of the stored checkpoints, newest first.
    virtual Result<std::vector<std::uint32_t>> checkpoint_ticks(const std::string& world) = 0;
    virtual Result<Checkpoint> checkpoint(const std::string& world, std::uint32_t tick) = 0;
    // The entries after a sequence number, in order: at least one if there is one, otherwise at
    // most `bytes_max` bytes of data. corrupt_data: also if an entry is missing in between.
    virtual Result<std::vector<JournalEntry>> entries(const std::string& world, std::uint64_t after,
                                                      std::size_t bytes_max) = 0;
    // Empty if there is no such note.
    virtual Result<std::optional<std::string>> note(const std::string& name) = 0;
    // unavailable: a file of the storage was removed or replaced since it was opened.
    virtual Status check_files() { return {}; }
    // Size of all files.
    virtual std::uint64_t bytes_on_disk() { return 0; }
};

}  // namespace jostle::server
