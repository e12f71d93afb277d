// SPDX-License-Identifier: MIT
//
// Reads recordings (proto/WIRE.md, "Recordings") with random access. The bytes are untrusted: each
// length is checked before use, and each record has a CRC. A truncated recording has no index;
// opening it scans the records and builds one. One thread at a time.
#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <string>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/client/recording_index.h"

namespace jostle::client {

/// Reader of a recording.
class RecordingReader {
public:
    /// Opens a recording. Returns an error if the file is not a recording or has no valid Welcome.
    static Result<RecordingReader> open(const std::string& path);
    static Result<RecordingReader> open(std::unique_ptr<std::istream> in);

    /// A record of the file.
    struct Record {
        std::uint64_t offset = 0, next = 0;  ///< byte offsets of this record and of the next one
        std::uint64_t arrived_us = 0;        ///< since the start of the recording
        std::uint32_t bytes = 0;             ///< of the message
        v1::ServerMessage message;
    };
    /// Reads the record at first(), at `next` of another record or at an index entry; the offset
    /// must be before end(). Errors contain the byte offset.
    Result<Record> read(std::uint64_t offset);

    /// After an error of read(): the offset of the next intact record after `offset`, or end() if
    /// there is none.
    std::uint64_t next_intact(std::uint64_t offset);

    std::uint64_t first() const;                ///< offset of the record after the Welcome
    std::uint64_t end() const { return end_; }  ///< offset after the last complete record
    const v1::Welcome& welcome() const { return welcome_; }
    /// Start time of the recording, us since 1970.
    std::uint64_t start_unix_us() const { return start_unix_us_; }
    /// In the order of the file.
    const std::vector<RecordingEntry>& index() const { return index_; }
    /// Why the recording is incomplete: where it was truncated or why its index is invalid. Empty:
    /// it has an index; records may still be corrupt.
    const std::string& truncation_reason() const { return truncation_reason_; }
    /// Builds the index from the records, to verify the index of the file.
    std::vector<RecordingEntry> rebuild_index();

private:
    explicit RecordingReader(std::unique_ptr<std::istream> in) : in_(std::move(in)) {}
    // Result of a scan: the intact records, the end of the last one, and the first fault.
    struct ScanResult {
        std::vector<RecordingEntry> index;
        std::uint64_t end = 0;
        std::string fault;
    };
    ScanResult scan_to(std::uint64_t end);
    Status read_header();
    Status read_index();
    Status read_welcome();
    std::uint64_t next_intact_before(std::uint64_t offset, std::uint64_t end);
    bool read_bytes(std::uint64_t offset, std::uint64_t count, std::string& bytes);

    std::unique_ptr<std::istream> in_;
    std::uint64_t size_ = 0, end_ = 0, start_unix_us_ = 0, after_welcome_ = 0;
    v1::Welcome welcome_;
    std::vector<RecordingEntry> index_;
    std::string truncation_reason_;
    std::string bytes_;  // reused
};

}  // namespace jostle::client
