// SPDX-License-Identifier: MIT
//
// Reads recordings (proto/WIRE.md, "Recordings"): any record by its place in the file. The bytes
// are foreign: each length is checked before it is believed, each record has a CRC. A recording
// that was cut off has no index; opening it then walks from record to record and makes one. One
// thread at a time.
#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <string>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/client/recording_index.h"

namespace jostle::client {

class RecordingReader {
public:
    static Result<RecordingReader> open(const std::string& path);
    static Result<RecordingReader> open(std::unique_ptr<std::istream> in);

    struct Record {
        std::uint64_t offset = 0, next = 0;  // where it is, and the one after it
        std::uint64_t arrived_us = 0;        // since the recording began
        std::uint32_t bytes = 0;             // of the message
        v1::ServerMessage message;
    };
    // The record at first(), or at `next` of another, or at an entry of the index; before end().
    // An error names the byte.
    Result<Record> read(std::uint64_t offset);

    std::uint64_t first() const;                // the record after the Welcome
    std::uint64_t end() const { return end_; }  // after the last whole record
    const v1::Welcome& welcome() const { return welcome_; }
    std::uint64_t start_unix_us() const { return start_unix_us_; }
    // In the order of the file.
    const std::vector<RecordingEntry>& index() const { return index_; }
    // Why it is not whole: where it was cut off, or what became of its index. Empty: it is whole.
    const std::string& truncation_reason() const { return truncation_reason_; }
    // The index anew, from the records; for who wants to know whether the one of the file is right.
    std::vector<RecordingEntry> rebuild_index();

private:
    explicit RecordingReader(std::unique_ptr<std::istream> in) : in_(std::move(in)) {}
    // As far as the records go; what stopped it, if it was not their end.
    struct ScanResult {
        std::vector<RecordingEntry> index;
        std::uint64_t end = 0;
        std::string fault;
    };
    ScanResult scan_to(std::uint64_t end);
    Status read_header();
    Status read_index();
    Status read_welcome();
    bool read_bytes(std::uint64_t offset, std::uint64_t count, std::string& bytes);

    std::unique_ptr<std::istream> in_;
    std::uint64_t size_ = 0, end_ = 0, start_unix_us_ = 0, after_welcome_ = 0;
    v1::Welcome welcome_;
    std::vector<RecordingEntry> index_;
    std::string truncation_reason_;
    std::string bytes_;  // reused
};

}  // namespace jostle::client
