// SPDX-License-Identifier: MIT
//
// What one client knows of its world: who is there (entities) and where they are (snapshots). It
// knows no network: it is handed messages. One thread at a time.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>

#include "jostle/base/result.h"
#include "jostle/v1/play.pb.h"
#include "wire/frame_codec.h"
#include "wire/quantize.h"

namespace jostle::client {

class WorldView {
public:
    static constexpr std::size_t ring = 32;  // decoded frames kept as bases of later ones

    // A new stream: everything is forgotten.
    void begin(const v1::Welcome& welcome);
    // Who came and who went.
    void apply(const v1::Roster& roster);
    // Decodes a snapshot and compares its CRC. An error leaves the last good frame in place; the
    // client should ask for a keyframe.
    Status apply(const v1::Snapshot& snapshot);

    // The newest; frame 0, without entities, until the first snapshot.
    const wire::QuantizedFrame& frame() const { return frames_.empty() ? none_ : frames_.back(); }
    // By id: what they look like, and who owns them.
    const std::map<std::uint32_t, v1::Entity>& entities() const { return entities_; }
    const wire::QuantSpec& spec() const { return spec_; }
    // Nothing when the entity is not in the newest frame.
    std::optional<wire::Pose> pose_of(std::uint32_t entity) const;

private:
    const wire::QuantizedFrame* find(std::uint32_t frame) const;

    wire::QuantSpec spec_;
    wire::QuantizedFrame none_;
    std::deque<wire::QuantizedFrame> frames_;
    std::map<std::uint32_t, v1::Entity> entities_;
};

}  // namespace jostle::client
