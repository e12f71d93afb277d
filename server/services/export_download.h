// SPDX-License-Identifier: MIT
//
// Exports of worlds that clients download in pieces, because gRPC clients receive at most 4 MiB per
// message by default. The first call stores the export, later ones name it. One at a time; an
// export that nobody reads is deleted. Any thread.
#pragma once

#include <cstdint>
#include <mutex>
#include <string>

#include "jostle/base/result.h"
#include "server/util/clock.h"

namespace jostle::server {

class ExportDownload {
public:
    static constexpr std::size_t piece_bytes_max = 1 << 20;
    static constexpr Clock::duration idle_max = std::chrono::seconds(10);

    struct Piece {
        std::string id;           // of the export
        std::uint64_t bytes = 0;  // of the whole export
        std::string data;
    };
    // resource_exhausted: another export is being read.
    Status admit(Clock::time_point now);
    // Stores the export of a world and returns its first piece. Errors as of admit().
    Result<Piece> begin(std::string world, std::string bytes, Clock::time_point now);
    // not_found: there is no such export of this world, or it was not read for idle_max.
    Result<Piece> read(const std::string& world, const std::string& id, std::uint64_t offset,
                       Clock::time_point now);
    // Deletes the export if it was not read for idle_max.
    void remove_idle(Clock::time_point now);

private:
    Status admit_locked(Clock::time_point now) const;
    Piece piece_locked(std::uint64_t offset) const;

    std::mutex mutex_;
    std::string id_;  // empty: no export
    std::string world_, bytes_;
    Clock::time_point last_read_;
};

}  // namespace jostle::server
