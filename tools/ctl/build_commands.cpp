// SPDX-License-Identifier: MIT
#include "tools/ctl/build_commands.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "jostle/scenes/scene_file.h"
#include "tools/common/table.h"
#include "tools/ctl/inspection_text.h"
#include "tools/ctl/outcome.h"

namespace jostle::ctl {

using common::Align, common::Table, common::number_text, common::sanitized;

using Admin = v1::AdminService::Stub;
using Query = v1::QueryService::Stub;

namespace {

void write(v1::Vec3& to, const std::vector<double>& from) {
    to.set_x(from.at(0)), to.set_y(from.at(1)), to.set_z(from.at(2));
}

Result<v1::ApplyInputResponse> apply(Connection& server, const CommandArguments& arguments,
                                     const v1::Input& input, std::uint32_t client = 0) {
    v1::ApplyInputRequest request;
    request.set_world(arguments.world);
    request.set_client(client);
    *request.mutable_input() = input;
    return server.call(&Admin::ApplyInput, request);
}

// "ff8000" or "#ff8000"
Result<std::uint32_t> parse_color(std::string text) {
    if (text.starts_with('#')) text.erase(0, 1);
    std::uint32_t color = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), color, 16);
    if (text.size() != 6 || failure != std::errc() || end != text.data() + text.size())
        return invalid_argument("\"" + text +
                                "\" is no colour; write six hexadecimal digits, such as ff8000");
    return color;
}

// The rotation that turns the z axis, the axis of hinges and sliders, to this one.
Result<v1::Quat> rotation_to(const std::vector<double>& axis) {
    const double length = std::hypot(axis.at(0), axis.at(1), axis.at(2));
    if (!(length > 1e-9)) return invalid_argument("--axis is 0 0 0; it must have a direction");
    const double x = axis[0] / length, y = axis[1] / length, z = axis[2] / length;
    v1::Quat turn;
    if (z < -0.999999) {  // half a turn about x
        turn.set_x(1);
        return turn;
    }
    const double w = 1 + z, norm = std::sqrt(x * x + y * y + w * w);
    turn.set_x(-y / norm);
    turn.set_y(x / norm);
    turn.set_w(w / norm);
    return turn;
}

void write_limit(v1::Limit& to, const std::vector<double>& from) {
    to.set_lower(from.at(0));
    to.set_upper(from.at(1));
}

// A flag that the kind of the joint does not have is an error.
Status write_kind(v1::Joint& joint, const CommandArguments& a) {
    const bool is_axial = a.kind == "hinge" || a.kind == "slider";
    if (!a.limit.empty() && !is_axial && a.kind != "distance")
        return invalid_argument("--limit is for hinge, slider and distance joints, not for " +
                                a.kind);
    if (a.motor.size() == 2 && !is_axial)
        return invalid_argument("--motor is for hinge and slider joints, not for " + a.kind);
    if (a.kind == "ball") {
        joint.mutable_ball();
    } else if (a.kind == "fixed") {
        joint.mutable_fixed();
    } else if (a.kind == "hinge") {
        v1::HingeJoint& hinge = *joint.mutable_hinge();
        if (!a.limit.empty()) write_limit(*hinge.mutable_limit(), a.limit);
        if (!a.motor.empty()) {
            hinge.set_motor_speed(a.motor[0]);
            hinge.set_motor_max_torque(a.motor[1]);
        }
    } else if (a.kind == "slider") {
        v1::SliderJoint& slider = *joint.mutable_slider();
        if (!a.limit.empty()) write_limit(*slider.mutable_limit(), a.limit);
        if (!a.motor.empty()) {
            slider.set_motor_speed(a.motor[0]);
            slider.set_motor_max_force(a.motor[1]);
        }
    } else if (a.kind == "distance") {
        if (a.limit.empty())
            return invalid_argument(
                "a distance joint needs its shortest and longest length: --limit 0 2");
        joint.mutable_distance()->set_min_length(a.limit[0]);
        joint.mutable_distance()->set_max_length(a.limit[1]);
    } else {
        return invalid_argument("\"" + a.kind +
                                "\" is no kind of joint; write ball, hinge, slider, fixed or "
                                "distance, or describe the joint in a --file");
    }
    return {};
}

Status write_joint(v1::Joint& joint, const CommandArguments& a) {
    if (!a.file.empty()) {
        const Result<std::string> text = read_file(a.file);
        if (!text.ok()) return text.error();
        if (Status s = scenes::read_json_message(*text, joint); !s.ok())
            return invalid_argument(a.file + ": " + s.error().message);
        return {};
    }
    if (Status s = write_kind(joint, a); !s.ok()) return s;
    if (!a.position.empty()) {
        write(*joint.mutable_frame()->mutable_position(), a.position);
        if (!a.axis.empty()) {
            const Result<v1::Quat> turn = rotation_to(a.axis);
            if (!turn.ok()) return turn.error();
            *joint.mutable_frame()->mutable_rotation() = *turn;
        }
    } else if (a.kind != "distance") {
        return invalid_argument("a " + a.kind + " joint needs its point in the world: --at 0 2 0");
    }
    joint.set_break_force(a.break_force);
    joint.set_break_torque(a.break_torque);
    joint.set_collide_connected(a.collides);
    return {};
}

}  // namespace

Outcome inspect(Connection& server, const CommandArguments& arguments) {
    v1::InspectRequest request;
    request.set_world(arguments.world);
    if (arguments.joint != 0)
        request.set_joint(arguments.joint);
    else
        request.set_entity(arguments.entity);
    const auto response = server.call(&Query::Inspect, request);
    if (!response.ok()) return server_error(response.error());
    return {.text = arguments.json ? json_text(*response) : inspection_text(*response)};
}

Outcome edit(Connection& server, const CommandArguments& a) {
    v1::Input input;
    v1::EditInput& edit = *input.mutable_edit();
    edit.set_entity(a.entity);
    if (!a.position.empty()) write(*edit.mutable_position(), a.position);
    if (!a.rotation.empty()) {
        v1::Quat& turn = *edit.mutable_rotation();
        turn.set_x(a.rotation.at(0)), turn.set_y(a.rotation.at(1));
        turn.set_z(a.rotation.at(2)), turn.set_w(a.rotation.at(3));
    }
    if (!a.velocity.empty()) write(*edit.mutable_linear_velocity(), a.velocity);
    if (!a.angular_velocity.empty()) write(*edit.mutable_angular_velocity(), a.angular_velocity);
    if (a.mass) edit.set_mass(*a.mass);
    if (a.density) edit.set_density(*a.density);
    if (a.friction) edit.set_friction(*a.friction);
    if (a.restitution) edit.set_restitution(*a.restitution);
    if (a.gravity_scale) edit.set_gravity_scale(*a.gravity_scale);
    if (!a.color.empty()) {
        const Result<std::uint32_t> color = parse_color(a.color);
        if (!color.ok()) return usage_error(color.error());
        edit.set_color(*color);
    }
    if (a.freeze || a.unfreeze) edit.set_frozen(a.freeze);
    return outcome_of(apply(server, a, input), a, [&](const auto&) {
        return "entity " + std::to_string(a.entity) + " of " + sanitized(a.world) + " is changed";
    });
}

Outcome clone(Connection& server, const CommandArguments& a) {
    v1::Input input;
    input.mutable_clone()->set_entity(a.entity);
    write(*input.mutable_clone()->mutable_offset(), a.offset);
    input.mutable_clone()->set_jointed(a.jointed);
    return outcome_of(apply(server, a, input), a, [&](const auto& response) {
        return "entity " + std::to_string(response.entity()) + " is the copy of entity " +
               std::to_string(a.entity);
    });
}

Outcome create_joint(Connection& server, const CommandArguments& a) {
    v1::Input input;
    v1::CreateJointInput& create = *input.mutable_create_joint();
    create.set_entity_a(a.entity_a);
    create.set_entity_b(a.entity_b);
    if (Status s = write_joint(*create.mutable_joint(), a); !s.ok()) return usage_error(s.error());
    return outcome_of(apply(server, a, input), a, [&](const auto& response) {
        return "joint " + std::to_string(response.joint()) + " connects " +
               (a.entity_a == 0 ? "the world" : "entity " + std::to_string(a.entity_a)) +
               " and entity " + std::to_string(a.entity_b);
    });
}

Outcome delete_joint(Connection& server, const CommandArguments& a) {
    v1::Input input;
    input.mutable_delete_joint()->set_joint(a.joint);
    return outcome_of(apply(server, a, input), a, [&](const auto&) {
        return "joint " + std::to_string(a.joint) + " is deleted";
    });
}

Outcome undo_newest(Connection& server, const CommandArguments& a) {
    v1::Input input;
    input.mutable_undo();
    return outcome_of(apply(server, a, input, a.client), a, [&](const auto& response) {
        return "the newest action of client " + std::to_string(a.client) + " is undone" +
               (response.entity() != 0
                    ? "; it concerned entity " + std::to_string(response.entity())
                : response.joint() != 0 ? "; it concerned joint " + std::to_string(response.joint())
                                        : std::string());
    });
}

}  // namespace jostle::ctl
