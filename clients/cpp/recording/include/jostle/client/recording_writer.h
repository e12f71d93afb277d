// SPDX-License-Identifier: MIT
//
// Writes the messages of a server into a recording (proto/WIRE.md, "Recordings"). Each record is
// self-contained: after a crash of the program the file is readable up to the last complete record.
// finish() adds the index, which a reader rebuilds if it is missing. One thread at a time.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/client/recording_index.h"

namespace jostle::client {

/// Writer of a recording.
class RecordingWriter {
public:
    /// `out`: an empty binary stream that outlives the writer. `start_unix_us`: start time, us
    /// since 1970.
    RecordingWriter(std::ostream& out, std::uint64_t start_unix_us);

    /// Adds a ServerMessage as received, the Welcome first. `arrived_us`: arrival time since the
    /// start of the recording. On an error the message is not part of the recording. After
    /// resource_exhausted (a write error) nothing more can be written.
    Status add(const std::string& bytes, std::uint64_t arrived_us);
    /// Writes the index. No records may follow.
    Status finish();

    /// Totals of the recording.
    struct Counts {
        std::uint64_t records = 0, bytes = 0;  ///< bytes: size of the file
        std::uint64_t snapshots = 0, keyframes = 0;
        std::uint32_t first_tick = 0, last_tick = 0;  ///< of snapshots
        std::uint64_t arrived_us = 0;                 ///< of the newest message
    };
    const Counts& counts() const { return counts_; }

private:
    Status may_add(const std::string& bytes);
    void count();
    Status write(const std::string& bytes);

    std::ostream& out_;
    v1::ServerMessage message_;  // reused, so that parsing rarely allocates
    std::string record_;         // likewise
    std::vector<RecordingEntry> index_;
    Counts counts_;
};

}  // namespace jostle::client
