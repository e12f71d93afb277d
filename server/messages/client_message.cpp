// SPDX-License-Identifier: MIT
#include "server/messages/client_message.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "jostle/base/check.h"
#include "jostle/scenes/joint_definition.h"
#include "jostle/scenes/shape_message.h"
#include "jostle/v1/play.pb.h"
#include "server/limits/admission.h"
#include "server/messages/attribute_message.h"
#include "server/messages/message_parts.h"
#include "server/messages/room_message.h"

namespace jostle::server {

using google::protobuf::internal::WireFormatLite;
using google::protobuf::io::CodedOutputStream;
namespace {

// All zeros means no rotation; other values are normalized. Values without a direction are
// rejected.
Result<physics::Quat> to_rotation(const v1::Quat& q) {
    const physics::Quat quat{q.x(), q.y(), q.z(), q.w()};
    const double size = norm_squared(quat);
    if (size == 0) return physics::Quat{};
    if (!(size > 1e-12 && size < 1e12))
        return invalid_argument("rotation is not a quaternion near unit length");
    return normalized(quat);
}

// Rejects shapes that cannot be spawned before the cost of building them.
Status check_kind(const v1::Shape& shape) {
    switch (shape.kind_case()) {
        case v1::Shape::kPlane:
        case v1::Shape::kMesh:
        case v1::Shape::kSolid:
        case v1::Shape::kHeightField:
        case v1::Shape::kCompound: {
            const auto* kind = v1::Shape::descriptor()->FindFieldByNumber(shape.kind_case());
            return invalid_argument(
                fmt::format("spawn.shape is a {}; {}", kind->name(), spawned_shapes_allowed));
        }
        case v1::Shape::kHull:
            if (shape.hull().points_size() > spawned_hull_points_max)
                return invalid_argument(fmt::format("spawn.shape.hull.points has {} entries; {}",
                                                    shape.hull().points_size(),
                                                    spawned_shapes_allowed));
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
    command.shape_bytes = spawn.shape().SerializeAsString();
    command.shape = *shape;
    command.pose = {to_vector(spawn.position()), *rotation};
    command.linear_velocity = to_vector(spawn.linear_velocity());
    command.angular_velocity = to_vector(spawn.angular_velocity());
    if (spawn.has_color()) command.color = spawn.color() & 0xffffff;
    return Action{command};
}

std::optional<Aim> to_aim(bool present, const v1::Aim& from) {
    if (!present) return std::nullopt;
    Aim aim{.origin = to_vector(from.origin()),
            .motion = to_vector(from.motion()),
            .ignore = from.ignore()};
    if (from.has_view_time())
        aim.view_time = {from.view_time().tick(), from.view_time().fraction()};
    return aim;
}

Result<Action> action_of(const v1::ImpulseInput& impulse) {
    ImpulseCommand command{.entity = impulse.entity(),
                           .impulse = to_vector(impulse.impulse()),
                           .point = std::nullopt,
                           .aim = to_aim(impulse.has_aim(), impulse.aim()),
                           .point_object = impulse.object()};
    if (impulse.object() != 0 && !impulse.has_aim() && !impulse.has_point())
        return invalid_argument("impulse.object is set without impulse.point; set both");
    if (impulse.has_point()) command.point = to_vector(impulse.point());
    return Action{command};
}

Result<Action> action_of(const v1::ControlInput& control) {
    ControlCommand command;
    auto& axes = command.controls.axes;
    if (control.axes_size() > static_cast<int>(axes.size()))
        return invalid_argument(fmt::format("control.axes has {} entries; at most {} are allowed",
                                            control.axes_size(), axes.size()));
    for (int k = 0; k < control.axes_size(); k++)
        axes[static_cast<std::size_t>(k)] = control.axes(k) / 1000.0;
    command.controls.buttons = control.buttons();
    return Action{command};
}

Result<Action> action_of(const v1::SetAttributesInput& input) {
    Result<SetAttributesCommand> command = to_attribute_changes(input.set(), "set_attributes.set.");
    if (!command.ok()) return command.error();
    return Action{*std::move(command)};
}

Action action_of(const v1::SendMessageInput& input) {
    return SendMessageCommand{.topic = input.topic(),
                              .data = input.data(),
                              .to = {input.to().begin(), input.to().end()},
                              .to_server = input.to_server()};
}

Result<Action> action_of(const v1::EditInput& edit) {
    EditCommand command{.entity = edit.entity()};
    if (edit.has_position()) command.position = to_vector(edit.position());
    if (edit.has_rotation()) {
        const Result<physics::Quat> rotation = to_rotation(edit.rotation());
        if (!rotation.ok()) return invalid_argument("edit." + rotation.error().message);
        command.rotation = *rotation;
    }
    if (edit.has_linear_velocity()) command.linear_velocity = to_vector(edit.linear_velocity());
    if (edit.has_angular_velocity()) command.angular_velocity = to_vector(edit.angular_velocity());
    if (edit.has_mass()) command.mass = edit.mass();
    if (edit.has_density()) command.density = edit.density();
    if (edit.has_friction()) command.friction = edit.friction();
    if (edit.has_restitution()) command.restitution = edit.restitution();
    if (edit.has_color()) command.color = edit.color() & 0xffffff;
    if (edit.has_frozen()) command.frozen = edit.frozen();
    if (edit.has_gravity_scale()) command.gravity_scale = edit.gravity_scale();
    return Action{command};
}

Result<Action> action_of(const v1::CreateJointInput& input) {
    if (input.joint().path().points_size() > 0 ||
        input.joint().solver() != v1::JOINT_SOLVER_UNSPECIFIED)
        return invalid_argument(
            "create_joint.joint has a solver or is a path; allowed are ball, hinge, slider, fixed "
            "and distance joints without a solver");
    Result<scenes::JointDefinition> joint =
        scenes::joint_from_message(input.joint(), "create_joint.joint");
    if (!joint.ok()) return joint.error();
    return Action{CreateJointCommand{input.entity_a(), input.entity_b(), joint->frame,
                                     std::move(joint->joint)}};
}

Result<Action> action_of(const v1::Input& input) {
    switch (input.kind_case()) {
        case v1::Input::kSpawn:
            return action_of(input.spawn());
        case v1::Input::kImpulse:
            return action_of(input.impulse());
        case v1::Input::kGrab:
            return Action{GrabCommand{input.grab().entity(), to_vector(input.grab().point()),
                                      to_aim(input.grab().has_aim(), input.grab().aim()),
                                      input.grab().object()}};
        case v1::Input::kCut:
            return Action{CutCommand{.point_object = input.cut().object(),
                                     .point = to_vector(input.cut().point()),
                                     .aim = to_aim(input.cut().has_aim(), input.cut().aim())}};
        case v1::Input::kDrag:
            return Action{DragCommand{to_vector(input.drag().target())}};
        case v1::Input::kRelease:
            return Action{ReleaseCommand{}};
        case v1::Input::kDelete:
            return Action{DeleteCommand{input.delete_().entity()}};
        case v1::Input::kExplode:
            return Action{ExplodeCommand{to_vector(input.explode().center()),
                                         input.explode().radius(), input.explode().speed(),
                                         to_aim(input.explode().has_aim(), input.explode().aim())}};
        case v1::Input::kPossess:
            return Action{PossessCommand{input.possess().entity()}};
        case v1::Input::kControl:
            return action_of(input.control());
        case v1::Input::kSetAttributes:
            return action_of(input.set_attributes());
        case v1::Input::kSendMessage:
            return action_of(input.send_message());
        case v1::Input::kRename:
            return Action{RenameCommand{input.rename().name()}};
        case v1::Input::kRoom: {
            Result<RoomCommand> command = room_command_from_message(input.room());
            if (!command.ok()) return command.error();
            return Action{*std::move(command)};
        }
        case v1::Input::kEdit:
            return action_of(input.edit());
        case v1::Input::kClone:
            return Action{CloneCommand{input.clone().entity(), to_vector(input.clone().offset()),
                                       input.clone().jointed()}};
        case v1::Input::kCreateJoint:
            return action_of(input.create_joint());
        case v1::Input::kDeleteJoint:
            return Action{DeleteJointCommand{.joint = input.delete_joint().joint()}};
        case v1::Input::kUndo:
            return Action{UndoCommand{}};
        case v1::Input::KIND_NOT_SET:
            break;
    }
    return invalid_argument("the input is empty or of an unknown kind");
}

Ack decode(const v1::Ack& ack) {
    return {ack.frame(), ack.need_keyframe(), std::min(ack.ack_delay_ms(), ack_delay_ms_max),
            ack.ack_bits()};
}

Result<Interest> decode(const v1::Interest& interest) {
    const physics::Vec3 focus = to_vector(interest.focus());
    const auto within = [](double value) { return std::abs(value) <= 1e9; };
    if (!within(focus.x) || !within(focus.z))
        return invalid_argument("interest.focus is out of range; x and z must be within 1e9 m");
    if (!(interest.radius() == 0 || interest.radius() >= 1))
        return invalid_argument(
            "interest.radius is out of range; it must be 0 (the whole world) or at least 1 m");
    Interest decoded{.x_m = focus.x, .z_m = focus.z};
    if (interest.radius() != 0) decoded.radius_m = interest.radius();
    return decoded;
}

Status check_topics(const v1::Hello& hello) {
    if (hello.topics_size() > hello_topics_max)
        return invalid_argument(fmt::format("hello.topics has {} entries; at most {} are allowed",
                                            hello.topics_size(), hello_topics_max));
    for (int k = 0; k < hello.topics_size(); k++)
        if (hello.topics(k) != "*" && !is_key(hello.topics(k)))
            return invalid_argument(
                fmt::format("hello.topics[{}] is invalid; it must be \"*\" or 1 to 32 of the "
                            "characters a-z, 0-9, '_' and '.'",
                            k));
    return {};
}

Result<ClientMessage> decode(const v1::Hello& hello) {
    std::optional<Interest> area_of_interest;
    if (hello.has_interest()) {
        const Result<Interest> interest = decode(hello.interest());
        if (!interest.ok()) return invalid_argument("hello." + interest.error().message);
        area_of_interest = *interest;
    }
    std::optional<StreamPrecision> precision;
    if (hello.has_precision()) {
        const v1::Precision& wanted = hello.precision();
        precision = {{wanted.position(), wanted.rotation()}, wanted.far_factor()};
        if (Status s = check(*precision, "hello.precision."); !s.ok()) return s.error();
    }
    if (hello.max_kbps() != 0 && hello.max_kbps() < hello_kbps_min)
        return invalid_argument(
            fmt::format("hello.max_kbps is {}; it must be 0 (unlimited) or at least {}",
                        hello.max_kbps(), hello_kbps_min));
    if (hello.name().size() > client_name_bytes_max) {
        return invalid_argument(fmt::format("hello.name has {} bytes; at most {} are allowed",
                                            hello.name().size(), client_name_bytes_max));
    }
    if (hello.channels_size() > hello_channels_max) {
        return invalid_argument(fmt::format("hello.channels has {} entries; at most {} are allowed",
                                            hello.channels_size(), hello_channels_max));
    }
    if (hello.join_code().size() > join_code_bytes_max) {
        return invalid_argument(fmt::format("hello.join_code has {} bytes; at most {} are allowed",
                                            hello.join_code().size(), join_code_bytes_max));
    }
    if (hello.resume().token().size() > resume_token_bytes_max) {
        return invalid_argument(
            fmt::format("hello.resume.token has {} bytes; at most {} are allowed",
                        hello.resume().token().size(), resume_token_bytes_max));
    }
    std::optional<Hello::Resume> resume;
    if (hello.has_resume())
        resume = {hello.resume().token(), hello.resume().frame(), hello.resume().message()};
    if (Status s = check_topics(hello); !s.ok()) return s.error();
    std::optional<std::uint32_t> color;
    if (hello.has_color()) color = hello.color() & 0xffffff;
    return ClientMessage{Hello{.protocol = hello.protocol(),
                               .world = hello.world(),
                               .ticket = hello.ticket(),
                               .name = hello.name(),
                               .snapshot_hz = hello.snapshot_hz(),
                               .spectator = hello.spectator(),
                               .events = hello.events(),
                               .token = hello.token(),
                               .channels = {hello.channels().begin(), hello.channels().end()},
                               .codec = hello.codec(),
                               .max_kbps = hello.max_kbps(),
                               .interest = area_of_interest,
                               .precision = precision,
                               .packed_entities = hello.packed_entities(),
                               .datagrams = hello.datagrams(),
                               .resumable = hello.resumable(),
                               .resume = std::move(resume),
                               .joints = hello.joints(),
                               .room = hello.room(),
                               .players = hello.players(),
                               .attributes = hello.attributes(),
                               .topics = {hello.topics().begin(), hello.topics().end()},
                               .color = color,
                               .join_code = hello.join_code()}};
}

Result<ClientMessage> decode(const v1::InputBatch& batch) {
    const std::uint64_t first = batch.first_sequence();
    if (first == 0 && batch.inputs_size() > 0) {
        return invalid_argument("input.first_sequence is 0; inputs are numbered from 1");
    }
    if (first + static_cast<std::uint64_t>(batch.inputs_size()) > 0xffffffffu) {
        return invalid_argument(
            "input.first_sequence leaves no sequence numbers for the inputs; rejoin");
    }
    InputBatch decoded;
    decoded.first_sequence = batch.first_sequence();
    decoded.client_time_us = batch.client_time_us();
    if (batch.has_ack()) decoded.ack = decode(batch.ack());
    decoded.inputs.reserve(static_cast<std::size_t>(batch.inputs_size()));
    for (const v1::Input& input : batch.inputs()) {
        decoded.inputs.push_back(action_of(input));
        decoded.ticks.push_back(input.tick());
        ASSERT(decoded.inputs.size() == decoded.ticks.size());
    }
    return ClientMessage{std::move(decoded)};
}

}  // namespace

Result<Action> decode_input(const v1::Input& input) {
    return action_of(input);
}

bool looks_like_inputs(std::string_view bytes) {
    constexpr auto tag = static_cast<char>(v1::ClientMessage::kInputFieldNumber << 3 | 2);
    return !bytes.empty() && bytes.front() == tag;
}

Result<ClientMessage> decode_client_message(std::string_view bytes) {
    v1::ClientMessage message;
    if (!message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) {
        return invalid_argument(
            fmt::format("the {} bytes are not a jostle.v1.ClientMessage", bytes.size()));
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
        case v1::ClientMessage::kInterest: {
            const Result<Interest> interest = decode(message.interest());
            if (!interest.ok()) return interest.error();
            return ClientMessage{*interest};
        }
        case v1::ClientMessage::MESSAGE_NOT_SET:
            break;
    }
    return invalid_argument("the ClientMessage is empty or of an unknown kind");
}

}  // namespace jostle::server
