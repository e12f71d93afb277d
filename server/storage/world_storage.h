// SPDX-License-Identifier: MIT
//
// Where worlds are kept. One process writes; one thread at a time calls.
//
// Errors: unavailable or resource_exhausted (the disk is gone, slow or full: the same call may
// succeed later), corrupt_data (what is stored is not what was written; the message says where),
// already_exists and not_found (the change contradicts what is stored, and always will).
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

    // All of them or none, durable when it returns. Writing again what is there is no error, so
    // that who does not know whether a call took effect may repeat it.
    virtual Status write(std::span<const StorageChange> changes) = 0;

    virtual Result<std::vector<StoredWorld>> worlds() = 0;
    // The ticks of those that are there, newest first.
    virtual Result<std::vector<std::uint32_t>> checkpoint_ticks(const std::string& world) = 0;
    virtual Result<Checkpoint> checkpoint(const std::string& world, std::uint32_t tick) = 0;
    // Those after a sequence, in their order, at least one if there is one, and no more than that
    // many bytes of data otherwise. corrupt_data: also when one is missing between them.
    virtual Result<std::vector<JournalEntry>> entries(const std::string& world, std::uint64_t after,
                                                      std::size_t bytes_max) = 0;
    // Nothing: no such note was put.
    virtual Result<std::optional<std::string>> note(const std::string& name) = 0;
};

}  // namespace jostle::server
