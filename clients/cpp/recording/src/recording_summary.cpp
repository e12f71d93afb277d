// SPDX-License-Identifier: MIT
#include "jostle/client/recording_summary.h"

#include "jostle/client/added_entities.h"

#include <algorithm>
#include <set>

namespace jostle::client {

namespace {

const char* kind_name(const v1::ServerMessage& message) {
    switch (message.message_case()) {
        case v1::ServerMessage::kWelcome:
            return "welcome";
        case v1::ServerMessage::kEntityUpdate:
            return "roster";
        case v1::ServerMessage::kSnapshot:
            return "snapshot";
        case v1::ServerMessage::kPong:
            return "pong";
        case v1::ServerMessage::kNotice:
            return "notice";
        case v1::ServerMessage::kGeometry:
            return "geometry";
        case v1::ServerMessage::MESSAGE_NOT_SET:
            break;
    }
    return "unknown";
}

void count_snapshot(RecordingSummary& summary, const RecordingReader::Record& record) {
    const v1::Snapshot& snapshot = record.message.snapshot();
    if (summary.first_tick == 0) summary.first_tick = snapshot.frame();
    summary.last_tick = snapshot.frame();
    summary.user_messages += static_cast<std::uint64_t>(snapshot.messages_size());
    summary.attribute_updates += static_cast<std::uint64_t>(snapshot.attributes_size());
    for (const v1::PlayerUpdate& update : snapshot.players())
        summary.player_events += static_cast<std::uint64_t>(update.events_size());
    if (snapshot.baselines() != 0) return;
    summary.keyframes++;
    summary.keyframe_bytes += record.bytes;
}

}  // namespace

RecordingSummary summarize(RecordingReader& recording) {
    RecordingSummary summary;
    std::set<std::uint32_t> entities;
    for (std::uint64_t offset = recording.first(); offset < recording.end();) {
        const auto record = recording.read(offset);
        if (!record.ok()) {
            if (summary.errors++ == 0) summary.first_error = record.error().message;
            offset = recording.next_intact(offset);
            continue;
        }
        offset = record->next;
        const v1::ServerMessage& message = record->message;
        summary.messages[kind_name(message)]++;
        summary.message_bytes += record->bytes;
        summary.seconds = static_cast<double>(record->arrived_us) / 1e6;
        if (message.has_snapshot()) count_snapshot(summary, *record);
        for (const std::uint32_t id : message.entity_update().removed()) entities.erase(id);
        if (const auto added = added_entities(message.entity_update()); added.ok())
            for (const v1::Entity& entity : *added) entities.insert(entity.id());
        summary.entities_max = std::max(summary.entities_max, entities.size());
    }
    summary.entities = entities.size();
    return summary;
}

RecordingVerification check(Playback& playback) {
    RecordingVerification result;
    const auto note = [&](const std::string& first_error) {
        if (result.errors.size() < RecordingVerification::errors_max &&
            std::ranges::find(result.errors, first_error) == result.errors.end())
            result.errors.push_back(first_error);
    };
    RecordingReader& recording = playback.recording();
    if (!recording.truncation_reason().empty()) note(recording.truncation_reason());
    if (recording.rebuild_index() != recording.index())
        note("the index does not match the records: seeking may show a wrong state");
    for (;;) {
        const Result<bool> moved = playback.next();
        if (moved.ok() && !*moved) break;
        if (moved.ok()) {
            result.snapshots++;
            continue;
        }
        note(moved.error().message);
        for (Result<bool> skipped = playback.skip_to_keyframe();;
             skipped = playback.skip_to_keyframe()) {
            if (skipped.ok() && !*skipped) return result;
            if (skipped.ok()) break;
            note(skipped.error().message);
        }
    }
    return result;
}

}  // namespace jostle::client
