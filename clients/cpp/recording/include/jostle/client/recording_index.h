// SPDX-License-Identifier: MIT
//
// The entry points of a recording: its keyframes, and the messages on which all later ones depend.
#pragma once

#include <cstdint>
#include <optional>

#include "jostle/v1/play.pb.h"

namespace jostle::client {

/// An entry of the index.
struct RecordingEntry {
    enum class Kind : std::uint32_t {
        keyframe = 1,    ///< a snapshot without baselines
        persistent = 2,  ///< an EntityUpdate or a GeometryChunk: valid from there on
    };
    std::uint64_t offset = 0;  ///< of its record in the file
    std::uint32_t frame = 0;   ///< of a keyframe
    Kind kind = Kind::keyframe;

    friend bool operator==(const RecordingEntry&, const RecordingEntry&) = default;
};

/// Returns the index entry of a message; nothing if the index does not contain it.
inline std::optional<RecordingEntry> index_entry_for(const v1::ServerMessage& message,
                                                     std::uint64_t offset) {
    using Kind = RecordingEntry::Kind;
    if (message.has_entity_update() || message.has_geometry())
        return RecordingEntry{.offset = offset, .kind = Kind::persistent};
    if (message.has_snapshot() && message.snapshot().baselines() == 0)
        return RecordingEntry{offset, message.snapshot().frame(), Kind::keyframe};
    return std::nullopt;
}

}  // namespace jostle::client
