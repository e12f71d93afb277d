// SPDX-License-Identifier: MIT
#include "server/messages/server_message.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/wire_format_lite.h>

#include "jostle/base/check.h"
#include "jostle/snapshot/word_changes.h"
#include "jostle/v1/play.pb.h"
#include "server/messages/message_parts.h"

namespace jostle::server {

namespace {

v1::InputCode input_code_of(const Status& status) {
    if (status.ok()) return v1::INPUT_CODE_APPLIED;
    switch (status.error().code) {
        case ErrorCode::not_found:
            return v1::INPUT_CODE_NOT_FOUND;
        case ErrorCode::permission_denied:
            return v1::INPUT_CODE_NOT_ALLOWED;
        case ErrorCode::resource_exhausted:
            return v1::INPUT_CODE_LIMIT;
        case ErrorCode::unavailable:
            return v1::INPUT_CODE_UNAVAILABLE;
        default:
            return v1::INPUT_CODE_INVALID;
    }
}

v1::NoticeCode to_message(NoticeKind kind) {
    switch (kind) {
        case NoticeKind::draining:
            return v1::NOTICE_CODE_DRAINING;
        case NoticeKind::world_closed:
            return v1::NOTICE_CODE_WORLD_CLOSED;
        case NoticeKind::refused:
            return v1::NOTICE_CODE_REFUSED;
        case NoticeKind::rate_limit:
            return v1::NOTICE_CODE_RATE_LIMIT;
        case NoticeKind::world_restarted:
            return v1::NOTICE_CODE_WORLD_RESTARTED;
    }
    return v1::NOTICE_CODE_UNSPECIFIED;
}

v1::ChannelForm to_message(physics::ChannelForm form) {
    switch (form) {
        case physics::ChannelForm::params:
            return v1::CHANNEL_FORM_PARAMS;
        case physics::ChannelForm::points:
            return v1::CHANNEL_FORM_POINTS;
        case physics::ChannelForm::seed:
            return v1::CHANNEL_FORM_SEED;
    }
    return v1::CHANNEL_FORM_UNSPECIFIED;
}

v1::PointForm to_message(physics::PointForm form) {
    switch (form) {
        case physics::PointForm::loose:
            return v1::POINT_FORM_LOOSE;
        case physics::PointForm::strands:
            return v1::POINT_FORM_STRANDS;
        case physics::PointForm::grid:
            return v1::POINT_FORM_GRID;
        case physics::PointForm::triangles:
            return v1::POINT_FORM_TRIANGLES;
        case physics::PointForm::heights:
            return v1::POINT_FORM_HEIGHTS;
    }
    return v1::POINT_FORM_UNSPECIFIED;
}

}  // namespace

std::string encode_welcome(const Welcome& from) {
    v1::ServerMessage message;
    v1::Welcome& welcome = *message.mutable_welcome();
    welcome.set_client_id(from.client);
    welcome.set_world_id(from.world_id);
    welcome.set_world_name(from.world_name);
    welcome.set_tick(from.tick);
    welcome.set_tick_hz(from.tick_hz);
    welcome.set_snapshot_hz(from.snapshot_hz);
    welcome.set_ack_interval_ms(from.ack_interval_ms);
    v1::QuantSpec& quant = *welcome.mutable_quant();
    quant.set_units_per_meter(static_cast<std::uint32_t>(from.quant.units_per_meter));
    quant.set_rotation_component(static_cast<std::uint32_t>(from.quant.rotation_component));
    if (from.precision.near.is_set()) {
        v1::Precision& precision = *welcome.mutable_precision();
        precision.set_position(from.precision.near.position_m);
        precision.set_rotation(from.precision.near.rotation_rad);
        precision.set_far_factor(from.precision.far_factor);
    }
    welcome.set_server_time_us(from.server_time_us);
    welcome.set_epoch_us(from.epoch_us);
    welcome.set_cells(from.cells);
    write_vector(*welcome.mutable_gravity(), from.gravity);
    ASSERT(from.substeps >= 0);
    welcome.set_substeps(static_cast<std::uint32_t>(from.substeps));
    for (const physics::ChannelKind& kind : from.channels) {
        v1::ChannelKind& to = *welcome.add_channels();
        to.set_name(kind.name);
        to.set_form(to_message(kind.form));
        to.set_divisor(static_cast<std::uint32_t>(kind.divisor));
    }
    welcome.set_resume_token(from.resume_token);
    welcome.set_resumed(from.resumed);
    welcome.set_state_preserved(from.state_preserved);
    welcome.set_last_sequence(from.last_sequence);
    welcome.set_resume_timeout_seconds(from.resume_timeout_seconds);
    welcome.set_planar(from.planar);
    if (from.view) {
        v1::View& view = *welcome.mutable_view();
        write_vector(*view.mutable_eye(), from.view->eye);
        write_vector(*view.mutable_target(), from.view->target);
        view.set_field_of_view(from.view->field_of_view);
    }
    welcome.set_codec(static_cast<std::uint32_t>(from.codec));
    if (from.datagrams) {
        v1::DatagramCredentials& datagrams = *welcome.mutable_datagrams();
        datagrams.set_port(from.datagrams->port);
        datagrams.set_id(from.datagrams->credentials.id);
        datagrams.set_key(from.datagrams->credentials.key.data(),
                          from.datagrams->credentials.key.size());
    }
    return message.SerializeAsString();
}

std::string encode_geometry_chunk(const GeometryChunk& from) {
    v1::ServerMessage message;
    v1::GeometryChunk& chunk = *message.mutable_geometry();
    chunk.set_id(from.id);
    ASSERT(from.chunk < from.chunk_count);
    chunk.set_chunk(from.chunk);
    chunk.set_chunk_count(from.chunk_count);
    chunk.set_data(from.data.data(), from.data.size());
    return message.SerializeAsString();
}

std::string encode_pong(std::uint64_t client_time_us, std::uint64_t server_time_us) {
    v1::ServerMessage message;
    message.mutable_pong()->set_client_time_us(client_time_us);
    message.mutable_pong()->set_server_time_us(server_time_us);
    return message.SerializeAsString();
}

std::string encode_stats_field(const Frame& frame, std::uint32_t clients) {
    v1::Snapshot fields;
    v1::WorldStats& stats = *fields.mutable_stats();
    stats.set_tick(frame.tick);
    stats.set_bodies(static_cast<std::uint32_t>(frame.entities.size()));
    stats.set_awake(static_cast<std::uint32_t>(frame.awake));
    stats.set_contacts(static_cast<std::uint32_t>(frame.contacts));
    stats.set_clients(clients);
    stats.set_step_ms_mean(frame.tick_ms_mean);
    stats.set_time_scale(frame.time_scale);
    stats.set_step_ms_max(frame.tick_ms_max);
    stats.set_paused(frame.paused.value_or(""));
    stats.set_late_ticks(frame.late_ticks);
    stats.set_speed_percent(frame.speed_percent);
    if (frame.restorable_ticks)
        stats.mutable_restorable_ticks()->Add(frame.restorable_ticks->begin(),
                                              frame.restorable_ticks->end());
    return fields.SerializeAsString();
}

std::string encode_notice(NoticeKind kind, const std::string& text) {
    v1::ServerMessage message;
    message.mutable_notice()->set_code(to_message(kind));
    message.mutable_notice()->set_message(text);
    return message.SerializeAsString();
}

std::string encode_shared_snapshot(const EncodedSnapshot& encoded) {
    v1::Snapshot snapshot;
    ASSERT(encoded.baselines.baseline <= encoded.frame);
    snapshot.set_frame(encoded.frame);
    snapshot.set_baselines(snapshot::encode_baseline_frames(encoded.frame, encoded.baselines));
    snapshot.set_packed(encoded.packed.data(), encoded.packed.size());
    snapshot.set_crc(encoded.crc);
    snapshot.set_late_us(encoded.late_us);
    snapshot.set_unchanged_ticks(encoded.unchanged_ticks);
    if (const auto& channels = encoded.channels; !channels.bytes.empty()) {
        snapshot.set_channels(channels.bytes.data(), channels.bytes.size());
        snapshot.set_channels_crc(channels.crc);
    }
    return snapshot.SerializeAsString();
}

std::string encode_controlled_entity_field(const ControlledEntityState& state, std::uint32_t tick,
                                           std::span<const std::uint32_t> previous, bool keyframe) {
    if (keyframe) previous = {};
    snapshot::WordChanges changes = snapshot::changes_between(previous, state.words);
    v1::Snapshot fields;
    v1::ControlledEntityState& to = *fields.mutable_controlled_entity();
    to.set_entity(state.entity);
    to.set_module(state.module);
    to.set_tick(tick);
    to.set_words(static_cast<std::uint32_t>(state.words.size()));
    to.set_keyframe(keyframe);
    to.set_changed_mask(std::move(changes.changed));
    to.set_values(std::move(changes.values));
    return fields.SerializeAsString();
}

std::string encode_cell_field(const EncodedCell& from) {
    v1::Snapshot fields;
    v1::CellUpdate& cell = *fields.add_cells();
    ASSERT(from.baselines.baseline <= from.number);
    cell.set_cell(from.id);
    cell.set_number(from.number);
    cell.set_baselines(snapshot::encode_baseline_frames(from.number, from.baselines));
    cell.set_packed(from.packed.data(), from.packed.size());
    cell.set_crc(from.crc);
    return fields.SerializeAsString();
}

std::string encode_cells_left_field(std::span<const CellId> cells) {
    v1::Snapshot fields;
    fields.mutable_cells_left()->Add(cells.begin(), cells.end());
    return fields.SerializeAsString();
}

std::string encode_point_object_field(const PointObjectDescription& from) {
    v1::Snapshot fields;
    v1::PointObject& object = *fields.add_point_objects();
    object.set_id(from.id);
    object.set_kind(from.kind);
    object.set_key(from.key);
    object.set_entity(from.entity);
    object.set_form(to_message(from.form));
    object.set_step_um(from.step_um);
    object.set_points(from.points);
    object.set_columns(from.columns);
    object.mutable_strands()->Add(from.strands.begin(), from.strands.end());
    std::int32_t before = 0;
    for (const std::uint32_t corner : from.triangles) {
        object.add_triangles(static_cast<std::int32_t>(corner) - before);
        before = static_cast<std::int32_t>(corner);
    }
    object.set_radius(static_cast<float>(from.radius));
    if (from.color) object.set_color(*from.color);
    if (from.form == physics::PointForm::heights) {
        write_vector(*object.mutable_origin(), from.origin);
        object.set_spacing_x(static_cast<float>(from.spacing_x));
        object.set_spacing_z(static_cast<float>(from.spacing_z));
    }
    return fields.SerializeAsString();
}

std::string encode_points_field(const EncodedPoints& from) {
    v1::Snapshot fields;
    v1::PointUpdate& points = *fields.add_points();
    points.set_object(from.object);
    points.set_number(from.number);
    points.set_back(from.back);
    points.set_tick(from.tick);
    points.set_packed(from.packed.bytes.data(), from.packed.bytes.size());
    points.set_crc(from.packed.crc);
    return fields.SerializeAsString();
}

std::string encode_points_ended_field(std::span<const std::uint32_t> objects) {
    v1::Snapshot fields;
    fields.mutable_points_ended()->Add(objects.begin(), objects.end());
    return fields.SerializeAsString();
}

namespace {

void write_results(v1::ClientUpdate& to, std::span<const InputResult> results) {
    for (const InputResult& from : results) {
        v1::InputResult& result = *to.add_results();
        result.set_sequence(from.sequence);
        result.set_code(input_code_of(from.status));
        result.set_tick(from.tick);
        result.set_entity(from.entity);
        result.set_view_time_clamped(from.view_time_clamped);
        result.set_joint(from.joint);
        if (from.status.ok()) continue;
        result.set_message(from.status.error().message);
        result.set_retry_after_ms(static_cast<std::uint32_t>(from.status.error().retry_after_ms));
    }
}

}  // namespace

std::string encode_snapshot_header(const ClientUpdate& from, std::string_view more,
                                   std::size_t shared_bytes) {
    v1::Snapshot fields;
    if (from.input_sequence != 0 || from.echo_client_time_us != 0 || from.snapshots_skipped != 0 ||
        from.input_received != 0 || !from.results.empty()) {
        v1::ClientUpdate& own = *fields.mutable_client_update();
        own.set_input_sequence(from.input_sequence);
        own.set_echo_client_time_us(from.echo_client_time_us);
        own.set_snapshots_skipped(from.snapshots_skipped);
        own.set_input_margin_us(from.input_margin_us);
        own.set_input_received(from.input_received);
        write_results(own, from.results);
    }
    std::string own = fields.SerializeAsString();
    own += more;
    return encode_header(v1::ServerMessage::kSnapshotFieldNumber, own, shared_bytes);
}

std::size_t channels_size(std::string_view fields) {
    using google::protobuf::internal::WireFormatLite;
    google::protobuf::io::CodedInputStream in(reinterpret_cast<const std::uint8_t*>(fields.data()),
                                              static_cast<int>(fields.size()));
    std::size_t bytes = 0;
    for (int begin = 0; const std::uint32_t tag = in.ReadTag(); begin = in.CurrentPosition()) {
        if (!WireFormatLite::SkipField(&in, tag)) break;
        const int field = WireFormatLite::GetTagFieldNumber(tag);
        if (field == v1::Snapshot::kChannelsFieldNumber ||
            field == v1::Snapshot::kChannelsCrcFieldNumber)
            bytes += static_cast<std::size_t>(in.CurrentPosition() - begin);
    }
    return bytes;
}

}  // namespace jostle::server
