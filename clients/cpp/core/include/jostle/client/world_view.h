// SPDX-License-Identifier: MIT
//
// What one client knows of its world: who is there (entities), where, and what modules tell
// (snapshots). It knows no network: it is handed messages. One thread at a time.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/snapshot/channel_codec.h"
#include "jostle/snapshot/frame_codec.h"
#include "jostle/snapshot/quantize.h"
#include "jostle/v1/play.pb.h"

namespace jostle::client {

class InterestCells;

class WorldView {
public:
    static constexpr std::size_t frame_history_max =
        32;  // decoded frames kept as bases of later ones
    static constexpr std::size_t geometry_bytes_max = 256u << 20;  // of one large shape

    // A new stream: everything is forgotten.
    void begin(const v1::Welcome& welcome);
    // A stream that goes on where another one broke: all that is known still counts.
    void resume(const v1::Welcome& welcome);
    // A piece of a large shape. An error: it does not follow the piece before.
    Status apply(const v1::GeometryChunk& part);
    // Who came and who went.
    void apply(const v1::EntityUpdate& entity_update);
    // Decodes a snapshot and compares its CRC. An error leaves the last good frame in place; the
    // client should ask for a keyframe.
    Status apply(const v1::Snapshot& snapshot);

    // What this client drives. An error: it is not told against what is known; the next whole one
    // is taken again.
    Status apply(const v1::ControlledEntityState& controlled_entity);

    // On the server's clock, in us.
    struct SnapshotTimes {
        std::int64_t due_us = 0;  // of the tick
        // Until then all was as in the snapshot's base; nothing: that is not known.
        std::optional<std::int64_t> unchanged_until_us;
    };
    // Of a snapshot that was applied.
    SnapshotTimes times_of(const v1::Snapshot& snapshot) const;

    // The newest; frame 0, without entities, until the first snapshot. Without those of whom no
    // roster told yet: a datagram may overtake it.
    const wire::QuantizedFrame& frame() const {
        if (known_frame_) return *known_frame_;
        return frames_.empty() ? none_ : frames_.back().state;
    }
    // The same for pictures: of who sees a part of a world, what is far away and told less often
    // moves evenly from one telling to the next, a few ticks later.
    wire::QuantizedFrame rendered_frame() const;
    // Of the newest frame's number n: bit k says that frame n - 1 - k is known.
    std::uint32_t ack_bits() const;
    // By id: what they look like, and who owns them.
    const std::map<std::uint32_t, v1::Entity>& entities() const { return entities_; }
    // What a shape of an entity is: itself, or the large shape that it names, of which only the
    // kind is set. Null: it names one that was never told.
    const v1::Shape* resolve_shape(const v1::Shape& shape) const;
    const wire::QuantSpec& spec() const { return spec_; }
    wire::Codec codec() const { return codec_; }
    // Nothing when the entity is not in the newest frame.
    std::optional<wire::Pose> pose_of(std::uint32_t entity) const;
    // What modules of the world can tell (Welcome.channels).
    const std::vector<v1::ChannelKind>& channel_kinds() const { return kinds_; }
    // What they tell with the newest frame of the kinds that Hello named; values are foreign. Valid
    // until the next snapshot.
    const wire::Channels& channels() const;
    // The values of one of them; entity 0: the module itself. Empty: there is none.
    std::span<const std::int32_t> channel(std::string_view kind, std::uint32_t entity) const;

    // What this client drives, for who foresees it (jostle/modules/controlled_entity_state.h has
    // the words, which are foreign); entity 0: that was not told. It stays as it was told last.
    struct ControlledEntityState {
        std::uint32_t entity = 0, tick = 0;
        std::string module;
        std::vector<std::uint32_t> words;
    };
    const ControlledEntityState& controlled_entity() const { return controlled_entity_; }

private:
    struct KnownFrame {
        wire::QuantizedFrame state;
        wire::Channels channels;
    };

    const KnownFrame* find(std::uint32_t frame) const;
    void remove_unknown_entities();
    Result<wire::QuantizedFrame> decode_poses(const v1::Snapshot& snapshot,
                                              const wire::Baselines& baselines);

    wire::QuantSpec spec_;
    std::int64_t epoch_us_ = 0;
    double tick_us_ = 0;  // from tick to tick
    wire::Codec codec_ = wire::Codec::bits;
    wire::QuantizedFrame none_;
    wire::Channels no_channels_;
    std::vector<v1::ChannelKind> kinds_;
    std::deque<KnownFrame> frames_;
    bool datagrams_ = false;  // snapshots may overtake rosters
    std::optional<wire::QuantizedFrame>
        known_frame_;                       // the newest frame, where it has unknown entities
    std::shared_ptr<InterestCells> cells_;  // null: it is told of all of the world
    std::map<std::uint32_t, v1::Entity> entities_;
    std::map<std::uint64_t, v1::Shape> geometry_;  // large shapes, by id
    ControlledEntityState controlled_entity_;
    struct PartialGeometry {
        std::uint64_t id = 0;
        std::uint32_t next = 0;
        std::string bytes;
    } partial_geometry_;  // the large shape of which pieces arrive
};

}  // namespace jostle::client
