// SPDX-License-Identifier: MIT
#include "jostle/client/recording_reader.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <optional>
#include <utility>

#include "clients/cpp/recording/src/recording_format.h"

namespace jostle::client {

using namespace recording;

namespace {

Error fault_at(std::uint64_t byte, const std::string& what) {
    return {ErrorCode::corrupt_data, "byte " + std::to_string(byte) + ": " + what};
}

std::optional<RecordingEntry::Kind> kind_of(std::uint32_t number) {
    using Kind = RecordingEntry::Kind;
    for (const Kind kind : {Kind::keyframe, Kind::persistent})
        if (number == static_cast<std::uint32_t>(kind)) return kind;
    return std::nullopt;
}

}  // namespace

Result<RecordingReader> RecordingReader::open(const std::string& path) {
    auto in = std::make_unique<std::ifstream>(path, std::ios::binary);
    if (!*in)
        return Error{ErrorCode::not_found, "cannot read " + path + ": " + std::strerror(errno)};
    Result<RecordingReader> reader = open(std::unique_ptr<std::istream>(std::move(in)));
    if (!reader.ok()) return Error{reader.error().code, path + ": " + reader.error().message};
    return reader;
}

Result<RecordingReader> RecordingReader::open(std::unique_ptr<std::istream> in) {
    RecordingReader reader(std::move(in));
    if (Status status = reader.read_header(); !status.ok()) return status.error();
    if (Status status = reader.read_index(); !status.ok()) {
        ScanResult scan = reader.scan_to(reader.end_ = reader.size_);
        reader.end_ = scan.end;
        reader.index_ = std::move(scan.index);
        reader.truncation_reason_ = scan.fault.empty() ? status.error().message : scan.fault;
    }
    if (Status status = reader.read_welcome(); !status.ok()) return status.error();
    return reader;
}

std::uint64_t RecordingReader::first() const {
    return after_welcome_;
}

bool RecordingReader::read_bytes(std::uint64_t offset, std::uint64_t count, std::string& bytes) {
    if (offset > size_ || count > size_ - offset) return false;
    bytes.resize(count);
    in_->clear();
    in_->seekg(static_cast<std::streamoff>(offset));
    in_->read(bytes.data(), static_cast<std::streamsize>(count));
    return static_cast<std::uint64_t>(in_->gcount()) == count;
}

Status RecordingReader::read_header() {
    in_->seekg(0, std::ios::end);
    const std::streamoff size = in_->tellg();
    if (size < 0) return Error{ErrorCode::not_found, "not a seekable file"};
    size_ = static_cast<std::uint64_t>(size);
    if (!read_bytes(0, header_bytes, bytes_) || !bytes_.starts_with(magic))
        return fault_at(0, "not a recording: the file does not start with " + std::string(magic) +
                               "; use a file written by jostle-record");
    if (const auto file_version = get<std::uint32_t>(bytes_, 4); file_version != version)
        return fault_at(4, "unsupported version " + std::to_string(file_version) +
                               "; this program reads version " + std::to_string(version) +
                               "; use a program of the same release");
    start_unix_us_ = get<std::uint64_t>(bytes_, 8);
    return {};
}

// Returns an error if the file has no valid index.
Status RecordingReader::read_index() {
    std::string trailer;
    if (size_ < header_bytes + index_head_bytes + trailer_bytes ||
        !read_bytes(size_ - trailer_bytes, trailer_bytes, trailer) || !trailer.ends_with(end_magic))
        return fault_at(size_, "no index: the recording is truncated");
    const auto index_offset = get<std::uint64_t>(trailer, 0);
    const std::uint64_t count = get<std::uint32_t>(trailer, 8);
    const std::uint64_t bytes = index_head_bytes + count * entry_bytes + trailer_bytes;
    if (bytes > size_ - header_bytes || index_offset != size_ - bytes ||
        !read_bytes(index_offset, bytes, bytes_))
        return fault_at(size_ - trailer_bytes, "invalid offset of the index");
    const std::string_view checked =
        std::string_view(bytes_).substr(crc_from, bytes - crc_from - end_magic.size());
    if (get<std::uint32_t>(bytes_, 0) != 0 || get<std::uint32_t>(bytes_, 4) != crc_of(checked))
        return fault_at(index_offset, "the index is corrupt");
    std::uint64_t previous = header_bytes;
    for (std::uint64_t k = 0; k < count; k++) {
        const std::size_t at = index_head_bytes + k * entry_bytes;
        const auto kind = kind_of(get<std::uint32_t>(bytes_, at + 12));
        const RecordingEntry entry{get<std::uint64_t>(bytes_, at),
                                   get<std::uint32_t>(bytes_, at + 8),
                                   kind.value_or(RecordingEntry::Kind::keyframe)};
        if (!kind || entry.offset <= previous || entry.offset >= index_offset) {
            index_.clear();
            return fault_at(index_offset + at, "invalid entry of the index");
        }
        previous = entry.offset;
        index_.push_back(entry);
    }
    end_ = index_offset;
    return {};
}

std::vector<RecordingEntry> RecordingReader::rebuild_index() {
    return scan_to(end_).index;
}

RecordingReader::ScanResult RecordingReader::scan_to(std::uint64_t end) {
    ScanResult scan;
    std::string word;
    for (scan.end = header_bytes; scan.end < end;) {
        // Messages are never empty: a length of 0 marks the index.
        if (read_bytes(scan.end, 4, word) && get<std::uint32_t>(word, 0) == 0) break;
        const Result<Record> record = read(scan.end);
        if (!record.ok()) {
            if (scan.fault.empty()) scan.fault = record.error().message;
            const std::uint64_t next = next_intact_before(scan.end, end);
            if (next == end) break;
            scan.end = next;
            continue;
        }
        if (const auto entry = index_entry_for(record->message, scan.end))
            scan.index.push_back(*entry);
        scan.end = record->next;
    }
    return scan;
}

std::uint64_t RecordingReader::next_intact(std::uint64_t offset) {
    return next_intact_before(offset, end_);
}

// Tries each byte as the start of a record. Random bytes rarely have a plausible length; what a
// crafted file can make this read is bounded.
std::uint64_t RecordingReader::next_intact_before(std::uint64_t offset, std::uint64_t end) {
    constexpr std::uint64_t window = 1 << 20;
    std::uint64_t checked_bytes_left = 64 << 20;
    std::string bytes;
    while (++offset < end) {
        if (!read_bytes(offset, std::min(window, end - offset), bytes)) return end;
        for (std::uint64_t k = 0; k + record_header_bytes < bytes.size(); k++) {
            const std::uint64_t length = get<std::uint32_t>(bytes, k);
            const std::uint64_t room = end - offset - k - record_header_bytes;
            if (length == 0 || length > message_bytes_max || length > room) continue;
            if (length > checked_bytes_left) return end;
            checked_bytes_left -= length;
            if (read(offset + k).ok()) return offset + k;
        }
        if (bytes.size() <= record_header_bytes) return end;
        offset += bytes.size() - record_header_bytes - 1;
    }
    return end;
}

Status RecordingReader::read_welcome() {
    if (end_ <= header_bytes)
        return fault_at(header_bytes,
                        "the recording is empty: " +
                            (truncation_reason_.empty() ? "no messages" : truncation_reason_));
    Result<Record> record = read(header_bytes);
    if (!record.ok()) return record.error();
    if (!record->message.has_welcome())
        return fault_at(header_bytes,
                        "the first message is not a Welcome; the recording cannot be "
                        "played without it");
    welcome_ = std::move(*record->message.mutable_welcome());
    after_welcome_ = record->next;
    return {};
}

Result<RecordingReader::Record> RecordingReader::read(std::uint64_t offset) {
    if (offset > end_ || end_ - offset < record_header_bytes ||
        !read_bytes(offset, record_header_bytes, bytes_))
        return fault_at(offset, "truncated record header");
    const auto length = get<std::uint32_t>(bytes_, 0);
    const auto crc = get<std::uint32_t>(bytes_, 4);
    if (length == 0 || length > message_bytes_max)
        return fault_at(offset, "message of " + std::to_string(length) +
                                    " bytes is out of range; must be 1 to " +
                                    std::to_string(message_bytes_max));
    const std::uint64_t rest = record_header_bytes - crc_from + length;
    if (rest > end_ - offset - crc_from || !read_bytes(offset + crc_from, rest, bytes_))
        return fault_at(offset, "message of " + std::to_string(length) +
                                    " bytes is truncated after " +
                                    std::to_string(end_ - offset - record_header_bytes) + " bytes");
    if (crc_of(bytes_) != crc) return fault_at(offset, "CRC mismatch: the record is corrupt");
    Record record{.offset = offset,
                  .next = offset + crc_from + rest,
                  .arrived_us = get<std::uint64_t>(bytes_, 0),
                  .bytes = length,
                  .message = {}};
    if (!record.message.ParseFromArray(bytes_.data() + 8, static_cast<int>(length)))
        return fault_at(offset, "the record is not a ServerMessage");
    return record;
}

}  // namespace jostle::client
