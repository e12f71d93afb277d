// SPDX-License-Identifier: MIT
//
// Backups that clients download in pieces: the first call makes the backup, later ones name it. One
// at a time; a backup that nobody reads is deleted. Any thread.
#pragma once

#include <cstdint>
#include <mutex>
#include <string>

#include "jostle/base/result.h"
#include "server/util/clock.h"
#include "server/world/world_persistence.h"

namespace jostle::server {

class BackupDownload {
public:
    static constexpr std::size_t piece_bytes_max = 1 << 20;
    static constexpr Clock::duration idle_max = std::chrono::seconds(60);

    struct Piece {
        std::string id;           // of the backup
        std::uint64_t bytes = 0;  // of the whole backup
        std::string data;
    };
    // Makes a backup and returns its first piece; blocks. resource_exhausted: another one is being
    // made or read.
    Result<Piece> begin(WorldPersistence& persistence, Clock::time_point now);
    // not_found: there is no such backup, or it was not read for idle_max.
    Result<Piece> read(const std::string& id, std::uint64_t offset, Clock::time_point now);
    // Deletes the backup if it was not read for idle_max.
    void remove_idle(Clock::time_point now);

private:
    Result<Piece> read_locked(std::uint64_t offset);
    bool is_idle(Clock::time_point now) const { return now - last_read_ > idle_max; }

    std::mutex mutex_;
    bool is_making_ = false;
    TemporaryFile file_;  // null: none
    std::string id_;
    std::uint64_t bytes_ = 0;
    Clock::time_point last_read_;
};

}  // namespace jostle::server
