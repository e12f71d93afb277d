// SPDX-License-Identifier: MIT
#include "jostle/client/recording_writer.h"

#include <algorithm>

#include "clients/cpp/recording/src/recording_format.h"

namespace jostle::client {

using namespace recording;

RecordingWriter::RecordingWriter(std::ostream& out, std::uint64_t start_unix_us) : out_(out) {
    record_ = magic;
    put(record_, version);
    put(record_, start_unix_us);
    // A failed write is reported with the first record.
    static_cast<void>(write(record_));
}

Status RecordingWriter::write(const std::string& bytes) {
    out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    if (!out_)
        return Error{ErrorCode::resource_exhausted,
                     "write failed after byte " + std::to_string(counts_.bytes) +
                         "; the recording up to there can be played; check the free disk space"};
    counts_.bytes += bytes.size();
    return {};
}

Status RecordingWriter::may_add(const std::string& bytes) {
    if (bytes.empty() || bytes.size() > message_bytes_max)
        return invalid_argument("message of " + std::to_string(bytes.size()) +
                                " bytes is out of range; must be 1 to " +
                                std::to_string(message_bytes_max));
    if (!message_.ParseFromString(bytes))
        return Error{ErrorCode::corrupt_data, "the message is not a ServerMessage"};
    if (message_.has_welcome() != (counts_.records == 0))
        return Error{ErrorCode::failed_precondition,
                     "a recording must contain exactly one Welcome, as its first message"};
    if (message_.has_welcome() && message_.welcome().cells())
        return Error{ErrorCode::failed_precondition,
                     "the stream covers only an area of interest; join without an interest and "
                     "without a bandwidth limit to record the whole world"};
    return {};
}

Status RecordingWriter::add(const std::string& bytes, std::uint64_t arrived_us) {
    if (Status status = may_add(bytes); !status.ok()) return status;
    arrived_us = std::max(arrived_us, counts_.arrived_us);
    std::string checked;
    put(checked, arrived_us);
    checked += bytes;
    record_.clear();
    put(record_, static_cast<std::uint32_t>(bytes.size()));
    put(record_, crc_of(checked));
    record_ += checked;
    const std::uint64_t offset = counts_.bytes;
    if (Status status = write(record_); !status.ok()) return status;
    counts_.arrived_us = arrived_us;
    if (const auto entry = index_entry_for(message_, offset)) index_.push_back(*entry);
    count();
    return {};
}

void RecordingWriter::count() {
    counts_.records++;
    if (!message_.has_snapshot()) return;
    const v1::Snapshot& snapshot = message_.snapshot();
    if (counts_.snapshots++ == 0) counts_.first_tick = snapshot.frame();
    counts_.last_tick = snapshot.frame();
    if (snapshot.baselines() == 0) counts_.keyframes++;
}

Status RecordingWriter::finish() {
    std::string checked;
    for (const RecordingEntry& entry : index_) {
        put(checked, entry.offset);
        put(checked, entry.frame);
        put(checked, static_cast<std::uint32_t>(entry.kind));
    }
    put(checked, counts_.bytes);
    put(checked, static_cast<std::uint32_t>(index_.size()));
    std::string index;
    put(index, std::uint32_t{0});
    put(index, crc_of(checked));
    index += checked;
    index += end_magic;
    if (Status status = write(index); !status.ok()) return status;
    out_.flush();
    return write({});
}

}  // namespace jostle::client
