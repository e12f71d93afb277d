// SPDX-License-Identifier: MIT
#include "jostle/client/playback.h"

#include <ranges>
#include <string>
#include <utility>

namespace jostle::client {

Playback::Playback(RecordingReader recording)
    : recording_(std::move(recording)), position_(recording_.first()) {
    view_.begin(recording_.welcome());
}

// Finds the next snapshot, if any; records that must be applied before it are only noted.
Status Playback::find_next_snapshot() {
    if (next_snapshot_) return {};
    persistent_records_.clear();
    for (std::uint64_t offset = position_; offset < recording_.end();) {
        Result<RecordingReader::Record> record = recording_.read(offset);
        if (!record.ok()) {
            position_ = offset;
            return record.error();
        }
        offset = record->next;
        if (record->message.has_snapshot()) {
            next_snapshot_ = *std::move(record);
            return {};
        }
        if (const auto entry = index_entry_for(record->message, record->offset))
            persistent_records_.push_back(entry->offset);
    }
    return {};
}

Status Playback::apply(const v1::ServerMessage& message, std::uint64_t offset) {
    Status status;
    if (message.has_entity_update()) status = view_.apply(message.entity_update());
    if (message.has_geometry()) status = view_.apply(message.geometry());
    if (message.has_snapshot()) {
        status = view_.apply(message.snapshot());
        // A keyframe contains the complete lists.
        view_.apply_data(message.snapshot());
        // After a seek, an object appears with its next keyframe.
        static_cast<void>(view_.apply_points(message.snapshot()).ok());
    }
    if (status.ok()) return status;
    return Error{status.error().code,
                 "byte " + std::to_string(offset) + ": " + status.error().message};
}

// After an error playback can continue only at a keyframe.
Error Playback::broken(Error error) {
    incomplete_ = true;
    return error;
}

Result<bool> Playback::next() {
    if (Status status = find_next_snapshot(); !status.ok()) return broken(status.error());
    if (!next_snapshot_) return false;
    const RecordingReader::Record snapshot = *std::exchange(next_snapshot_, std::nullopt);
    position_ = snapshot.next;
    for (const std::uint64_t offset : std::exchange(persistent_records_, {})) {
        const auto record = recording_.read(offset);
        if (!record.ok()) return broken(record.error());
        if (Status s = apply(record->message, offset); !s.ok()) return broken(s.error());
    }
    if (Status s = apply(snapshot.message, snapshot.offset); !s.ok()) return broken(s.error());
    arrived_us_ = snapshot.arrived_us;
    return true;
}

const RecordingEntry* Playback::keyframe_before(std::uint32_t tick) const {
    for (const RecordingEntry& entry : std::views::reverse(recording_.index()))
        if (entry.kind == RecordingEntry::Kind::keyframe && entry.frame <= tick) return &entry;
    return nullptr;
}

// Entity updates accumulate from the start of the recording, so all of them are applied; snapshots
// are skipped.
Status Playback::restart_at(const RecordingEntry& keyframe) {
    view_.begin(recording_.welcome());
    incomplete_ = false;
    next_snapshot_.reset();
    position_ = keyframe.offset;
    for (const RecordingEntry& entry : recording_.index()) {
        if (entry.offset >= keyframe.offset) break;
        if (entry.kind != RecordingEntry::Kind::persistent) continue;
        const auto record = recording_.read(entry.offset);
        if (!record.ok()) return broken(record.error());
        if (Status s = apply(record->message, entry.offset); !s.ok()) return broken(s.error());
    }
    return {};
}

Status Playback::seek(std::uint32_t tick) {
    const RecordingEntry* keyframe = keyframe_before(tick);
    if (!keyframe) {
        std::string start = "; it has no keyframe";
        for (const RecordingEntry& entry : std::views::reverse(recording_.index()))
            if (entry.kind == RecordingEntry::Kind::keyframe)
                start = ", which starts at tick " + std::to_string(entry.frame);
        return Error{ErrorCode::not_found,
                     "tick " + std::to_string(tick) + " is before the recording" + start};
    }
    const std::uint32_t now = view_.frame().frame;
    if (incomplete_ || now == 0 || now > tick || position_ <= keyframe->offset)
        if (Status status = restart_at(*keyframe); !status.ok()) return status;
    // Records after the tick are irrelevant and may be corrupt.
    while (view_.frame().frame != tick) {
        if (Status status = find_next_snapshot(); !status.ok()) return broken(status.error());
        if (!next_snapshot_) break;
        if (next_snapshot_->message.snapshot().frame() > tick) return {};
        if (const auto moved = next(); !moved.ok()) return moved.error();
    }
    const std::uint32_t last = view_.frame().frame;
    if (last >= tick) return {};
    return Error{ErrorCode::not_found, "tick " + std::to_string(tick) +
                                           " is after the recording, which ends at tick " +
                                           std::to_string(last)};
}

Result<bool> Playback::skip_to_keyframe() {
    for (const RecordingEntry& entry : recording_.index()) {
        if (entry.kind != RecordingEntry::Kind::keyframe || entry.offset <= position_) continue;
        if (Status status = restart_at(entry); !status.ok()) return status.error();
        return true;
    }
    return false;
}

}  // namespace jostle::client
