// SPDX-License-Identifier: MIT
//
// Writes what a server sent into a file that can be played again (proto/WIRE.md, "Recordings").
// Each record is whole by itself: whatever was written when a program dies is readable up to the
// last whole record. finish() adds the index, which a reader makes by itself where it is missing.
// One thread at a time.
#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/client/recording_index.h"

namespace jostle::client {

class RecordingWriter {
public:
    // `out` is empty, binary, and outlives the writer. When it begins: us since 1970.
    RecordingWriter(std::ostream& out, std::uint64_t start_unix_us);

    // A ServerMessage as it came, the Welcome first, and when: us since the recording began. An
    // error: it is not in the recording. After one of the file (resource_exhausted) nothing more
    // can be written.
    Status add(const std::string& bytes, std::uint64_t arrived_us);
    // The index; nothing comes after it.
    Status finish();

    struct Counts {
        std::uint64_t records = 0, bytes = 0;  // bytes: of the file
        std::uint64_t snapshots = 0, keyframes = 0;
        std::uint32_t first_tick = 0, last_tick = 0;  // of snapshots
        std::uint64_t arrived_us = 0;                 // of the newest
    };
    const Counts& counts() const { return counts_; }

private:
    Status may_add(const std::string& bytes);
    void count();
    Status write(const std::string& bytes);

    std::ostream& out_;
    v1::ServerMessage message_;  // reused: parsing then allocates rarely
    std::string record_;         // likewise
    std::vector<RecordingEntry> index_;
    Counts counts_;
};

}  // namespace jostle::client
