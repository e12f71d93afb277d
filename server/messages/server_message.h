// SPDX-License-Identifier: MIT
//
// Encodes server messages (events: event_message.h). Each function returns the bytes of one
// ServerMessage of play.proto, or one of the two pieces of a Snapshot. Pure functions; any thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "jostle/datagram/packet.h"
#include "jostle/scenes/scene.h"
#include "server/replication/cell_snapshot_cache.h"
#include "server/replication/point_cache.h"
#include "server/replication/pose_cache.h"
#include "server/replication/snapshot_cache.h"
#include "server/world/command.h"
#include "server/world/frame.h"

namespace jostle::server {

struct Welcome {
    ClientId client = 0;
    std::string world_id, world_name;
    std::uint32_t tick = 0;
    double tick_hz = 0;
    std::uint32_t snapshot_hz = 0;
    std::uint32_t ack_interval_ms = 0;
    snapshot::QuantSpec quant;
    StreamPrecision precision;
    std::uint64_t server_time_us = 0, epoch_us = 0;
    physics::Vec3 gravity;
    int substeps = 0;
    std::vector<physics::ChannelKind> channels;
    snapshot::Codec codec = snapshot::Codec::bits;
    bool cells = false;
    struct Datagrams {
        std::uint16_t port = 0;
        datagram::Credentials credentials;
    };
    std::optional<Datagrams> datagrams = {};
    std::string resume_token = {};  // empty: the session cannot be resumed
    bool resumed = false, state_preserved = false;
    std::uint32_t last_sequence = 0;
    double resume_timeout_seconds = 0;
    bool planar = false;
    std::optional<scenes::SceneView> view = {};  // nothing: chosen by the viewer
};
enum class NoticeKind { draining, world_closed, refused, rate_limit, world_restarted };

std::string encode_welcome(const Welcome& welcome);
// One chunk of a large shape.
struct GeometryChunk {
    std::uint64_t id = 0;
    std::uint32_t chunk = 0, chunk_count = 0;
    std::string_view data;
};
std::string encode_geometry_chunk(const GeometryChunk& piece);
std::string encode_pong(std::uint64_t client_time_us, std::uint64_t server_time_us);
std::string encode_notice(NoticeKind kind, const std::string& message);

// --- snapshots: the client's own piece followed by a shared piece forms one ServerMessage ---

// Zero or empty fields are unchanged since the last update.
struct ClientUpdate {
    std::uint32_t input_sequence = 0;
    std::uint32_t echo_client_time_us = 0;
    std::uint32_t snapshots_skipped = 0;
    std::span<const InputResult> results;
    std::int32_t input_margin_us = 0;
    std::uint32_t input_received = 0;
};
// Optional fields of jostle.v1.Snapshot.
std::string encode_stats_field(const Frame& frame, std::uint32_t clients);

// State of the controlled entity as a difference from the previously sent words; `keyframe`:
// complete.
std::string encode_controlled_entity_field(const ControlledEntityState& state, std::uint32_t tick,
                                           std::span<const std::uint32_t> previous, bool keyframe);

// The fields of jostle.v1.Snapshot shared by all clients.
std::string encode_shared_snapshot(const EncodedSnapshot& snapshot);
// A field of jostle.v1.Snapshot shared by all clients that see the cell.
std::string encode_cell_field(const EncodedCell& cell);
std::string encode_cells_left_field(std::span<const CellId> cells);
// Fields of jostle.v1.Snapshot for point objects.
std::string encode_point_object_field(const PointObjectDescription& object);
std::string encode_points_field(const EncodedPoints& points);
std::string encode_points_ended_field(std::span<const std::uint32_t> objects);
// The start of the message: the tag and length of the snapshot in its ServerMessage, then the
// client's own field and `more` fields.
std::string encode_snapshot_header(const ClientUpdate& own, std::string_view more,
                                   std::size_t shared_bytes);
// The bytes of the channels among encoded fields of a Snapshot.
std::size_t channels_size(std::string_view fields);

}  // namespace jostle::server
