// SPDX-License-Identifier: MIT
//
// The decoded state of one client's world: entities, poses and channels. It is independent of the
// network: the caller passes the messages. One thread at a time.
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
#include "jostle/client/joint_list.h"
#include "jostle/client/point_objects.h"
#include "jostle/client/world_data.h"
#include "jostle/snapshot/channel_codec.h"
#include "jostle/snapshot/frame_codec.h"
#include "jostle/snapshot/quantize.h"
#include "jostle/v1/play.pb.h"

namespace jostle::client {

class InterestCells;

/// The state of a world as received by one client.
class WorldView {
public:
    /// Number of decoded frames stored as baselines of later ones.
    static constexpr std::size_t frame_history_max = 32;
    static constexpr std::size_t geometry_bytes_max = 256u << 20;  ///< per chunked shape

    /// Starts a new stream and discards all state.
    void begin(const v1::Welcome& welcome);
    /// Starts a resumed stream. The server sends point objects again; all other state remains
    /// valid.
    void resume(const v1::Welcome& welcome);
    /// Adds a chunk of a large shape. Returns an error if it does not follow the previous chunk.
    Status apply(const v1::GeometryChunk& part);
    /// Adds and removes entities. Returns an error, and changes nothing, if the packed list is
    /// malformed.
    Status apply(const v1::EntityUpdate& entity_update);
    /// Decodes a snapshot and verifies its CRC. On an error the last valid frame remains current,
    /// and the client should request a keyframe.
    Status apply(const v1::Snapshot& snapshot);

    /// Applies the point objects of a snapshot, before or after apply(); see PointObjects::apply().
    Status apply_points(const v1::Snapshot& snapshot) { return points_.apply(snapshot); }

    /// Applies the players and attributes of a snapshot, before or after apply(). They do not
    /// depend on the poses.
    void apply_data(const v1::Snapshot& snapshot) { data_.apply(snapshot); }

    /// Applies the state of the controlled entity. Returns an error if its baseline is unknown; the
    /// next keyframe is accepted again.
    Status apply(const v1::ControlledEntityState& controlled_entity);

    /// Times on the server's clock, us.
    struct SnapshotTimes {
        std::int64_t due_us = 0;  ///< due time of the tick
        /// The state of the baseline was unchanged until this time; absent: unknown.
        std::optional<std::int64_t> unchanged_until_us;
    };
    /// Times of an applied snapshot.
    SnapshotTimes times_of(const v1::Snapshot& snapshot) const;

    /// The newest frame; frame 0 without entities before the first snapshot. Entities that no
    /// EntityUpdate has added yet are omitted, because a datagram may overtake it.
    const snapshot::QuantizedFrame& frame() const {
        if (known_frame_) return *known_frame_;
        return frames_.empty() ? none_ : frames_.back().state;
    }
    /// The newest frame for rendering. With an area of interest, distant entities, which are
    /// updated less often, are interpolated between their updates and lag a few ticks behind.
    snapshot::QuantizedFrame rendered_frame() const;
    /// For the number n of the newest frame: bit k means that frame n - 1 - k is stored.
    std::uint32_t ack_bits() const;
    /// Entities by id: shapes, name, owner.
    const std::map<std::uint32_t, v1::Entity>& entities() const { return entities_; }
    /// Returns the shape itself or the chunked shape that it refers to, of which only the kind is
    /// set. Null: the shape was never received.
    const v1::Shape* resolve_shape(const v1::Shape& shape) const;
    /// Quantization of the poses.
    const snapshot::QuantSpec& spec() const { return spec_; }
    /// Codec of the snapshots.
    snapshot::Codec codec() const { return codec_; }
    /// Returns nothing if the entity is not in the newest frame.
    std::optional<snapshot::Pose> pose_of(std::uint32_t entity) const;
    /// Channel kinds of the world (Welcome.channels).
    const std::vector<v1::ChannelKind>& channel_kinds() const { return kinds_; }
    /// Channels of the newest frame, of the kinds that Hello named; values are untrusted. Valid
    /// until the next snapshot.
    const snapshot::Channels& channels() const;
    /// Values of one channel; entity 0: the module itself. Empty: no such channel.
    std::span<const std::int32_t> channel(std::string_view kind, std::uint32_t entity) const;

    /// Point objects of the kinds that Hello named.
    PointObjects& points() { return points_; }
    const PointObjects& points() const { return points_; }

    /// Applies the joints of a snapshot, which are valid even if its poses cannot be decoded.
    Status apply(const v1::JointUpdate& update) { return joints_.apply(update); }
    /// Joints by id, if ClientOptions::joints is set.
    const std::map<std::uint32_t, ListedJoint>& joints() const { return joints_.joints(); }
    /// Players and attributes.
    const WorldData& data() const { return data_; }

    /// The state of the entity that this client controls, for prediction
    /// (jostle/modules/controlled_entity_state.h defines the words, which are untrusted). Entity 0:
    /// not received yet. The last received state is stored.
    struct ControlledEntityState {
        std::uint32_t entity = 0, tick = 0;
        std::string module;
        std::vector<std::uint32_t> words;
    };
    /// The last received state of the controlled entity.
    const ControlledEntityState& controlled_entity() const { return controlled_entity_; }

private:
    struct KnownFrame {
        snapshot::QuantizedFrame state;
        snapshot::Channels channels;
    };

    const KnownFrame* find(std::uint32_t frame) const;
    void remove_unknown_entities();
    Result<snapshot::QuantizedFrame> decode_poses(const v1::Snapshot& snapshot,
                                                  const snapshot::Baselines& baselines);

    snapshot::QuantSpec spec_;
    std::int64_t epoch_us_ = 0;
    double tick_us_ = 0;  // tick interval
    snapshot::Codec codec_ = snapshot::Codec::bits;
    snapshot::QuantizedFrame none_;
    snapshot::Channels no_channels_;
    std::vector<v1::ChannelKind> kinds_;
    std::deque<KnownFrame> frames_;
    bool datagrams_ = false;  // snapshots may overtake entity updates
    // The newest frame without its unknown entities, if it has any.
    std::optional<snapshot::QuantizedFrame> known_frame_;
    std::shared_ptr<InterestCells> cells_;  // null: the client receives the whole world
    std::map<std::uint32_t, v1::Entity> entities_;
    std::map<std::uint64_t, v1::Shape> geometry_;  // chunked shapes, by id
    PointObjects points_;
    JointList joints_;
    WorldData data_;
    ControlledEntityState controlled_entity_;
    struct PartialGeometry {
        std::uint64_t id = 0;
        std::uint32_t next = 0;
        std::string bytes;
    } partial_geometry_;  // the chunked shape that is being received
};

}  // namespace jostle::client
