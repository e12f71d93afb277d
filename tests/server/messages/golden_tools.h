// SPDX-License-Identifier: MIT
//
// The content of proto/golden/sandbox_tools.jmsg: the inputs that build and that control the time
// of a room, and the responses of QueryService.Inspect. The numbers are exact in binary, so that
// every build computes the same bytes.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "jostle/v1/play.pb.h"
#include "jostle/v1/query.pb.h"
#include "server/messages/inspection_message.h"

namespace jostle::server {

inline void set_golden(v1::Vec3& v, double x, double y, double z) {
    v.set_x(x), v.set_y(y), v.set_z(z);
}

// The inputs 7 to 14.
inline v1::ClientMessage golden_tool_inputs() {
    v1::ClientMessage message;
    v1::InputBatch& batch = *message.mutable_input();
    batch.set_first_sequence(7);
    v1::EditInput& edit = *batch.add_inputs()->mutable_edit();
    edit.set_entity(12);
    set_golden(*edit.mutable_position(), 1.5, -2, 0.25);
    edit.mutable_rotation()->set_y(1);
    set_golden(*edit.mutable_linear_velocity(), 0, 4, 0);
    set_golden(*edit.mutable_angular_velocity(), -0.5, 0, 0);
    edit.set_mass(20);
    edit.set_friction(0);  // present, and 0
    edit.set_restitution(0.75);
    edit.set_color(0xff8000);
    edit.set_frozen(false);
    edit.set_gravity_scale(-0.5);
    v1::CloneInput& clone = *batch.add_inputs()->mutable_clone();
    clone.set_entity(12);
    set_golden(*clone.mutable_offset(), 2, 0, -1);
    clone.set_jointed(true);
    v1::CreateJointInput& create = *batch.add_inputs()->mutable_create_joint();
    create.set_entity_b(12);
    v1::Joint& joint = *create.mutable_joint();
    set_golden(*joint.mutable_frame()->mutable_position(), 0, 3, 0);
    joint.mutable_frame()->mutable_rotation()->set_x(1);
    joint.mutable_hinge()->mutable_limit()->set_lower(-1);
    joint.mutable_hinge()->mutable_limit()->set_upper(1.25);
    joint.mutable_hinge()->set_motor_speed(2);
    joint.mutable_hinge()->set_motor_max_torque(300);
    joint.set_collide_connected(true);
    joint.set_break_force(5000);
    batch.add_inputs()->mutable_delete_joint()->set_joint(300);
    batch.add_inputs()->mutable_undo();
    batch.add_inputs()->mutable_room()->mutable_step()->set_steps(60);
    batch.add_inputs()->mutable_room()->mutable_speed()->set_percent(25);
    batch.add_inputs()->mutable_room()->mutable_rewind()->set_tick(1234);
    return message;
}

inline JointInspection golden_joint() {
    JointInspection joint{.id = 300, .entity_b = 12, .owner = 3};
    joint.state.def.kind =
        physics::HingeJoint{.limit = {.enabled = true, .lower = -1, .upper = 1.25},
                            .motor = {.enabled = true, .speed = 2, .max_torque = 300}};
    joint.state.def.frame_a.position = {0, 3, 0};
    joint.state.def.frame_b.position = {0, 1, 0};
    joint.state.def.break_force = 5000;
    joint.state.force = {0, 3, 4};  // 5 N
    joint.state.torque = {0, 0, -2};
    joint.state.angle = 0.5;
    joint.anchor_a = {0, 3, 0};
    joint.anchor_b = {0, 3.0009765625, 0};
    return joint;
}

inline BodyInspection golden_body() {
    auto entity = std::make_shared<EntityDescription>();
    entity->id = 12;
    entity->owner = 3;
    entity->name = "crate";
    physics::ShapeState shape{};
    shape.density = 800;
    shape.material.friction = 0.5;
    shape.material.restitution = 0.25;
    entity->shapes = {shape};
    BodyInspection body{.description = entity};
    body.state.pose.position = {1, 2, 3};
    body.state.center = {1, 2.5, 3};
    body.state.linear_velocity = {0, -2, 0};
    body.state.angular_velocity = {0, 0, 4};
    body.state.mass = 20;
    body.state.inertia = {{8, 0, 0}, {0, 16, 0}, {0, 0, 32}};
    body.state.awake = true;
    body.definition.gravity_scale = -0.5;
    body.contacts.push_back({.entity = 4,
                             .shape = 0,
                             .other_shape = 2,
                             .normal = {0, -1, 0},
                             .points = {{{1, 1.5, 3}, -0.0009765625, 3.25}, {{2, 1.5, 3}, 0, 0}}});
    body.contact_count = 300;
    body.joints.push_back(golden_joint());
    body.joint_count = 1;
    body.island = 4;
    body.island_bodies = 2;
    return body;
}

inline std::vector<v1::InspectResponse> golden_inspections() {
    std::vector<v1::InspectResponse> responses(2);
    responses[0].set_tick(1234);
    write_inspection(*responses[0].mutable_body(), golden_body());
    responses[1].set_tick(1235);
    write_inspection(*responses[1].mutable_joint(), golden_joint());
    return responses;
}

// All numbers are little-endian: "JMSG", u32 version, u32 number of messages, then for each its
// kind (u32; 0: ClientMessage, 1: InspectResponse), its length (u32) and its bytes.
inline std::string golden_tools() {
    const auto number = [](std::size_t value) {
        std::string bytes;
        for (int k = 0; k < 4; k++) bytes += static_cast<char>(value >> (8 * k));
        return bytes;
    };
    std::vector<std::pair<std::size_t, std::string>> messages;
    messages.emplace_back(0, golden_tool_inputs().SerializeAsString());
    for (const v1::InspectResponse& response : golden_inspections())
        messages.emplace_back(1, response.SerializeAsString());
    std::string file = "JMSG" + number(1) + number(messages.size());
    for (const auto& [kind, bytes] : messages) file += number(kind) + number(bytes.size()) + bytes;
    return file;
}

}  // namespace jostle::server
