// SPDX-License-Identifier: MIT
#include "jostle/client/recording_reader.h"

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
        ScanResult rebuild_index = reader.scan_to(reader.end_ = reader.size_);
        reader.end_ = rebuild_index.end;
        reader.index_ = std::move(rebuild_index.index);
        reader.truncation_reason_ =
            rebuild_index.fault.empty() ? status.error().message : rebuild_index.fault;
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
    if (size < 0) return Error{ErrorCode::not_found, "it is no file that can be read anywhere"};
    size_ = static_cast<std::uint64_t>(size);
    if (!read_bytes(0, header_bytes, bytes_) || !bytes_.starts_with(magic))
        return fault_at(0, "it is no recording, which begins with the letters " +
                               std::string(magic) + "; jostle-record makes one");
    if (const auto its = get<std::uint32_t>(bytes_, 4); its != version)
        return fault_at(4, "it is a recording of version " + std::to_string(its) +
                               "; this program reads version " + std::to_string(version) +
                               ", so play it with one of its own time");
    start_unix_us_ = get<std::uint64_t>(bytes_, 8);
    return {};
}

// An error: the file has none that can be believed.
Status RecordingReader::read_index() {
    std::string trailer;
    if (size_ < header_bytes + index_head_bytes + trailer_bytes ||
        !read_bytes(size_ - trailer_bytes, trailer_bytes, trailer) || !trailer.ends_with(end_magic))
        return fault_at(size_, "it has no index: it was cut off there");
    const auto begins = get<std::uint64_t>(trailer, 0);
    const std::uint64_t count = get<std::uint32_t>(trailer, 8);
    const std::uint64_t bytes = index_head_bytes + count * entry_bytes + trailer_bytes;
    if (bytes > size_ - header_bytes || begins != size_ - bytes ||
        !read_bytes(begins, bytes, bytes_))
        return fault_at(size_ - trailer_bytes, "its index is not where it should be");
    const std::string_view checked =
        std::string_view(bytes_).substr(crc_from, bytes - crc_from - end_magic.size());
    if (get<std::uint32_t>(bytes_, 0) != 0 || get<std::uint32_t>(bytes_, 4) != crc_of(checked))
        return fault_at(begins, "its index is damaged");
    std::uint64_t after = header_bytes;
    for (std::uint64_t k = 0; k < count; k++) {
        const std::size_t at = index_head_bytes + k * entry_bytes;
        const auto kind = kind_of(get<std::uint32_t>(bytes_, at + 12));
        const RecordingEntry entry{get<std::uint64_t>(bytes_, at),
                                   get<std::uint32_t>(bytes_, at + 8),
                                   kind.value_or(RecordingEntry::Kind::keyframe)};
        if (!kind || entry.offset <= after || entry.offset >= begins) {
            index_.clear();
            return fault_at(begins + at, "its index names what cannot be there");
        }
        after = entry.offset;
        index_.push_back(entry);
    }
    end_ = begins;
    return {};
}

std::vector<RecordingEntry> RecordingReader::rebuild_index() {
    return scan_to(end_).index;
}

RecordingReader::ScanResult RecordingReader::scan_to(std::uint64_t end) {
    ScanResult rebuild_index;
    std::string word;
    for (rebuild_index.end = header_bytes; rebuild_index.end < end;) {
        // No message is empty: there the index begins.
        if (read_bytes(rebuild_index.end, 4, word) && get<std::uint32_t>(word, 0) == 0) break;
        const Result<Record> record = read(rebuild_index.end);
        if (!record.ok()) {
            rebuild_index.fault = record.error().message;
            break;
        }
        if (const auto entry = index_entry_for(record->message, rebuild_index.end))
            rebuild_index.index.push_back(*entry);
        rebuild_index.end = record->next;
    }
    return rebuild_index;
}

Status RecordingReader::read_welcome() {
    if (end_ <= header_bytes)
        return fault_at(header_bytes, "nothing was recorded: " + (truncation_reason_.empty()
                                                                      ? "it has no message"
                                                                      : truncation_reason_));
    Result<Record> record = read(header_bytes);
    if (!record.ok()) return record.error();
    if (!record->message.has_welcome())
        return fault_at(header_bytes,
                        "its first message is no Welcome; without one nothing after "
                        "it can be understood");
    welcome_ = std::move(*record->message.mutable_welcome());
    after_welcome_ = record->next;
    return {};
}

Result<RecordingReader::Record> RecordingReader::read(std::uint64_t offset) {
    if (offset > end_ || end_ - offset < record_header_bytes ||
        !read_bytes(offset, record_header_bytes, bytes_))
        return fault_at(offset, "the file ends within the head of a record: it was cut off there");
    const auto length = get<std::uint32_t>(bytes_, 0);
    const auto crc = get<std::uint32_t>(bytes_, 4);
    if (length == 0 || length > message_bytes_max)
        return fault_at(offset, "a message of " + std::to_string(length) + " bytes, where 1 to " +
                                    std::to_string(message_bytes_max) + " can be: it is damaged");
    const std::uint64_t rest = record_header_bytes - crc_from + length;
    if (rest > end_ - offset - crc_from || !read_bytes(offset + crc_from, rest, bytes_))
        return fault_at(offset, "a message of " + std::to_string(length) +
                                    " bytes, of which the file has " +
                                    std::to_string(end_ - offset - record_header_bytes) +
                                    ": it was cut off there");
    if (crc_of(bytes_) != crc)
        return fault_at(offset, "the CRC of the record does not match: it is damaged");
    Record record{.offset = offset,
                  .next = offset + crc_from + rest,
                  .arrived_us = get<std::uint64_t>(bytes_, 0),
                  .bytes = length,
                  .message = {}};
    if (!record.message.ParseFromArray(bytes_.data() + 8, static_cast<int>(length)))
        return fault_at(offset, "the record is no ServerMessage");
    return record;
}

}  // namespace jostle::client
