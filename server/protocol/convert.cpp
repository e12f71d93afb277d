// SPDX-License-Identifier: MIT
#include "protocol/convert.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/wire_format_lite.h>
#include <spdlog/fmt/fmt.h>

#include <array>
#include <utility>

#include "jostle/scenes/shape_message.h"
#include "jostle/v1/play.pb.h"
#include "protocol/vector_message.h"
#include "session/admission.h"

namespace jostle::server {

using google::protobuf::internal::WireFormatLite;
using google::protobuf::io::CodedOutputStream;
namespace {

Error invalid(std::string message) {
    return {ErrorCode::invalid_argument, std::move(message)};
}

// All zero means no rotation, and readers normalise; what has no direction is refused.
Result<physics::Quat> to_rotation(const v1::Quat& q) {
    const physics::Quat quat{q.x(), q.y(), q.z(), q.w()};
    const double size = norm_squared(quat);
    if (size == 0) return physics::Quat{};
    if (!(size > 1e-12 && size < 1e12))
        return invalid("rotation is not a quaternion near unit length");
    return normalized(quat);
}

// What may never be spawned is refused before it costs the work of building it.
Status check_kind(const v1::Shape& shape) {
    switch (shape.kind_case()) {
        case v1::Shape::kPlane:
        case v1::Shape::kMesh:
        case v1::Shape::kHeightField:
        case v1::Shape::kCompound: {
            const auto* kind = v1::Shape::descriptor()->FindFieldByNumber(shape.kind_case());
            return invalid(
                fmt::format("spawn.shape is a {}; {}", kind->name(), spawned_shapes_allowed));
        }
        case v1::Shape::kHull:
            if (shape.hull().points_size() > spawned_hull_points_max)
                return invalid(fmt::format("spawn.shape.hull.points has {} entries; {}",
                                           shape.hull().points_size(), spawned_shapes_allowed));
            return {};
        default:
            return {};
    }
}

Result<Action> action_of(const v1::SpawnInput& spawn) {
    if (const Status kind = check_kind(spawn.shape()); !kind.ok()) return kind.error();
    Result<physics::ShapeDef> shape = scenes::shape_from_message(spawn.shape(), "spawn.shape");
    if (!shape.ok()) return shape.error();
    const Result<physics::Quat> rotation = to_rotation(spawn.rotation());
    if (!rotation.ok()) return rotation.error();
    SpawnCommand command;
    command.shape = *shape;
    command.pose = {to_vector(spawn.position()), *rotation};
    command.linear_velocity = to_vector(spawn.linear_velocity());
    command.angular_velocity = to_vector(spawn.angular_velocity());
    if (spawn.has_color()) command.color = spawn.color() & 0xffffff;
    return Action{command};
}

Result<Action> action_of(const v1::ImpulseInput& impulse) {
    ImpulseCommand command{
        .entity = impulse.entity(), .impulse = to_vector(impulse.impulse()), .point = std::nullopt};
    if (impulse.has_point()) command.point = to_vector(impulse.point());
    return Action{command};
}

Result<Action> action_of(const v1::Input& input) {
    switch (input.kind_case()) {
        case v1::Input::kSpawn:
            return action_of(input.spawn());
        case v1::Input::kImpulse:
            return action_of(input.impulse());
        case v1::Input::kGrab:
            return Action{GrabCommand{input.grab().entity(), to_vector(input.grab().point())}};
        case v1::Input::kDrag:
            return Action{DragCommand{to_vector(input.drag().target())}};
        case v1::Input::kRelease:
            return Action{ReleaseCommand{}};
        case v1::Input::kDelete:
            return Action{DeleteCommand{input.delete_().entity()}};
        case v1::Input::kExplode:
            return Action{ExplodeCommand{to_vector(input.explode().center()),
                                         input.explode().radius(), input.explode().speed()}};
        case v1::Input::KIND_NOT_SET:
            break;
    }
    return invalid("the input is empty, or of a kind that this server does not know");
}

Ack decode(const v1::Ack& ack) {
    return {ack.frame(), ack.need_keyframe()};
}

Result<ClientMessage> decode(const v1::Hello& hello) {
    if (hello.name().size() > client_name_bytes_max) {
        return invalid(fmt::format("hello.name has {} bytes; at most {} are allowed",
                                   hello.name().size(), client_name_bytes_max));
    }
    return ClientMessage{Hello{.protocol = hello.protocol(),
                               .world = hello.world(),
                               .ticket = hello.ticket(),
                               .name = hello.name(),
                               .snapshot_hz = hello.snapshot_hz(),
                               .spectator = hello.spectator(),
                               .events = hello.events()}};
}

Result<ClientMessage> decode(const v1::InputBatch& batch) {
    const std::uint64_t first = batch.first_sequence();
    if (first == 0 && batch.inputs_size() > 0) {
        return invalid("input.first_sequence is 0; inputs are numbered from 1");
    }
    if (first + static_cast<std::uint64_t>(batch.inputs_size()) > 0xffffffffu) {
        return invalid("input.first_sequence leaves no numbers for the inputs; join again");
    }
    InputBatch decoded;
    decoded.first_sequence = batch.first_sequence();
    decoded.client_time_us = batch.client_time_us();
    if (batch.has_ack()) decoded.ack = decode(batch.ack());
    decoded.inputs.reserve(static_cast<std::size_t>(batch.inputs_size()));
    for (const v1::Input& input : batch.inputs()) decoded.inputs.push_back(action_of(input));
    return ClientMessage{std::move(decoded)};
}

v1::BodyType to_message(physics::BodyType type) {
    switch (type) {
        case physics::BodyType::fixed:
            return v1::BODY_TYPE_FIXED;
        case physics::BodyType::kinematic:
            return v1::BODY_TYPE_KINEMATIC;
        case physics::BodyType::dynamic:
            return v1::BODY_TYPE_DYNAMIC;
    }
    return v1::BODY_TYPE_UNSPECIFIED;
}

void set(v1::Entity& to, const EntityDescription& from) {
    to.set_id(from.id);
    to.set_type(to_message(from.type));
    // Only what a viewer draws: where it is and how big. Density and material stay with the server.
    for (const physics::ShapeState& shape : from.shapes)
        scenes::write_outline(*to.add_shapes(), shape.geometry, shape.pose);
    to.set_owner(from.owner);
    if (from.color) to.set_color(*from.color);
    to.set_name(from.name);
    to.set_mass(from.mass);
}

v1::ContactEvent& set(v1::ContactEvent& to, const ContactEvent& from) {
    to.set_entity_a(from.a);
    to.set_entity_b(from.b);
    return to;
}

void set_place(v1::ContactEvent& to, const ContactEvent& from) {
    write_vector(*to.mutable_point(), from.point);
    write_vector(*to.mutable_normal(), from.normal);
}

void set(v1::TriggerEvent& to, const TriggerEvent& from) {
    to.set_trigger(from.trigger);
    to.set_entity(from.entity);
}

// A field of ServerMessage whose content is `fields` and, after these bytes, `shared_bytes` more:
// its tag, its length, then the fields.
std::string write_head(int field_number, const google::protobuf::MessageLite& fields,
                       std::size_t shared_bytes) {
    const std::uint32_t tag =
        WireFormatLite::MakeTag(field_number, WireFormatLite::WIRETYPE_LENGTH_DELIMITED);
    const std::size_t own_bytes = fields.ByteSizeLong();
    std::array<std::uint8_t, 10> bytes{};  // a tag and a length of five bytes at most each
    std::uint8_t* end = CodedOutputStream::WriteTagToArray(tag, bytes.data());
    end = CodedOutputStream::WriteVarint32ToArray(
        static_cast<std::uint32_t>(own_bytes + shared_bytes), end);
    std::string head(reinterpret_cast<const char*>(bytes.data()),
                     static_cast<std::size_t>(end - bytes.data()));
    fields.AppendToString(&head);
    return head;
}

v1::InputCode input_code_of(const Status& status) {
    if (status.ok()) return v1::INPUT_CODE_APPLIED;
    switch (status.error().code) {
        case ErrorCode::not_found:
            return v1::INPUT_CODE_NOT_FOUND;
        case ErrorCode::permission_denied:
            return v1::INPUT_CODE_NOT_ALLOWED;
        case ErrorCode::resource_exhausted:
            return v1::INPUT_CODE_LIMIT;
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
    }
    return v1::NOTICE_CODE_UNSPECIFIED;
}

}  // namespace

Result<ClientMessage> decode_client_message(std::string_view bytes) {
    v1::ClientMessage message;
    if (!message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) {
        return invalid(fmt::format("the {} bytes are not a jostle.v1.ClientMessage", bytes.size()));
    }
    switch (message.message_case()) {
        case v1::ClientMessage::kHello:
            return decode(message.hello());
        case v1::ClientMessage::kInput:
            return decode(message.input());
        case v1::ClientMessage::kAck:
            return ClientMessage{decode(message.ack())};
        case v1::ClientMessage::kPing:
            return ClientMessage{Ping{message.ping().client_time_us()}};
        case v1::ClientMessage::kLeave:
            return ClientMessage{Leave{}};
        case v1::ClientMessage::MESSAGE_NOT_SET:
            break;
    }
    return invalid("the ClientMessage is empty, or of a kind that this server does not know");
}

std::string encode_welcome(const Welcome& from) {
    v1::ServerMessage message;
    v1::Welcome& welcome = *message.mutable_welcome();
    welcome.set_client_id(from.client);
    welcome.set_world_id(from.world_id);
    welcome.set_world_name(from.world_name);
    welcome.set_tick(from.tick);
    welcome.set_tick_hz(from.tick_hz);
    welcome.set_snapshot_hz(from.snapshot_hz);
    welcome.set_ack_window(from.ack_window);
    v1::QuantSpec& quant = *welcome.mutable_quant();
    quant.set_units_per_meter(static_cast<std::uint32_t>(from.quant.units_per_meter));
    quant.set_rotation_component(static_cast<std::uint32_t>(from.quant.rotation_component));
    welcome.set_server_time_us(from.server_time_us);
    write_vector(*welcome.mutable_gravity(), from.gravity);
    return message.SerializeAsString();
}

std::string encode_roster(std::span<const std::shared_ptr<const EntityDescription>> added,
                          std::span<const EntityId> removed) {
    v1::ServerMessage message;
    v1::Roster& roster = *message.mutable_roster();
    for (const auto& entity : added) set(*roster.add_added(), *entity);
    for (const EntityId id : removed) roster.add_removed(id);
    return message.SerializeAsString();
}

std::string encode_input_results(std::span<const InputResult> results) {
    v1::ServerMessage message;
    for (const InputResult& from : results) {
        v1::InputResult& to = *message.mutable_input_results()->add_results();
        to.set_sequence(from.sequence);
        to.set_code(input_code_of(from.status));
        to.set_tick(from.tick);
        to.set_entity(from.entity);
        if (!from.status.ok()) to.set_message(from.status.error().message);
    }
    return message.SerializeAsString();
}

std::string encode_pong(std::uint64_t client_time_us, std::uint64_t server_time_us) {
    v1::ServerMessage message;
    message.mutable_pong()->set_client_time_us(client_time_us);
    message.mutable_pong()->set_server_time_us(server_time_us);
    return message.SerializeAsString();
}

std::string encode_world_stats(const Frame& frame, std::uint32_t clients) {
    v1::ServerMessage message;
    v1::WorldStats& stats = *message.mutable_stats();
    stats.set_tick(frame.tick);
    stats.set_bodies(static_cast<std::uint32_t>(frame.entities.size()));
    stats.set_awake(static_cast<std::uint32_t>(frame.awake));
    stats.set_contacts(static_cast<std::uint32_t>(frame.contacts));
    stats.set_clients(clients);
    stats.set_step_ms_mean(frame.step_ms_mean);
    stats.set_step_ms_max(frame.step_ms_max);
    stats.set_late_ticks(frame.late_ticks);
    return message.SerializeAsString();
}

std::string encode_notice(NoticeKind kind, const std::string& text) {
    v1::ServerMessage message;
    message.mutable_notice()->set_code(to_message(kind));
    message.mutable_notice()->set_message(text);
    return message.SerializeAsString();
}

std::string encode_shared_snapshot(const EncodedSnapshot& encoded) {
    v1::Snapshot snapshot;
    snapshot.set_frame(encoded.frame);
    snapshot.set_base_frame(encoded.bases.base);
    snapshot.set_base2_frame(encoded.bases.base2);
    snapshot.set_base3_frame(encoded.bases.base3);
    snapshot.set_packed(encoded.packed.data(), encoded.packed.size());
    snapshot.set_crc(encoded.crc);
    snapshot.set_server_time_us(to_us(encoded.due));
    return snapshot.SerializeAsString();
}

std::string encode_snapshot_head(const Private& from, std::size_t shared_bytes) {
    v1::Snapshot fields;
    v1::Private& own = *fields.mutable_own();
    own.set_input_sequence(from.input_sequence);
    own.set_echo_client_time_us(from.echo_client_time_us);
    own.set_snapshots_skipped(from.snapshots_skipped);
    return write_head(v1::ServerMessage::kSnapshotFieldNumber, fields, shared_bytes);
}

std::string encode_shared_events(const TickEvents& from) {
    v1::Events events;
    events.set_tick(from.tick);
    for (const ContactEvent& c : from.began) {
        v1::ContactEvent& contact = set(*events.add_contacts_began(), c);
        set_place(contact, c);
        contact.set_speed(c.speed);
    }
    for (const ContactEvent& c : from.ended) set(*events.add_contacts_ended(), c);
    for (const ContactEvent& c : from.contacts) {
        v1::ContactEvent& contact = set(*events.add_contacts(), c);
        set_place(contact, c);
        contact.set_impulse(c.impulse);
    }
    for (const ContactEvent& c : from.hits) {
        v1::ContactEvent& contact = set(*events.add_hits(), c);
        set_place(contact, c);
        contact.set_speed(c.speed);
    }
    for (const TriggerEvent& t : from.entered) set(*events.add_triggers_entered(), t);
    for (const TriggerEvent& t : from.stayed) set(*events.add_triggers_stayed(), t);
    for (const TriggerEvent& t : from.left) set(*events.add_triggers_left(), t);
    for (const JointBreakEvent& j : from.joints_broke) {
        v1::JointBreakEvent& joint = *events.add_joints_broke();
        joint.set_entity_a(j.a);
        joint.set_entity_b(j.b);
        joint.set_force(j.force);
        joint.set_torque(j.torque);
    }
    events.mutable_fell_asleep()->Add(from.fell_asleep.begin(), from.fell_asleep.end());
    events.mutable_woke()->Add(from.woke.begin(), from.woke.end());
    return events.SerializeAsString();
}

std::string encode_events_head(std::uint32_t missed, std::size_t shared_bytes) {
    v1::Events fields;
    fields.set_missed(missed);
    return write_head(v1::ServerMessage::kEventsFieldNumber, fields, shared_bytes);
}

}  // namespace jostle::server
