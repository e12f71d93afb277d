// SPDX-License-Identifier: MIT
#include "server/messages/client_message.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "jostle/v1/play.pb.h"
#include "server/limits/admission.h"

namespace jostle::server {
namespace {

template <class Message>
Message decode_as(const v1::ClientMessage& message) {
    const auto decoded = decode_client_message(message.SerializeAsString());
    EXPECT_TRUE(decoded.ok()) << decoded.error().message;
    return std::get<Message>(*decoded);
}

std::string refusal_of(const v1::ClientMessage& message) {
    const auto decoded = decode_client_message(message.SerializeAsString());
    return decoded.ok() ? "" : decoded.error().message;
}

TEST(ClientMessage, decodes_each_kind_of_input) {
    v1::ClientMessage message;
    v1::InputBatch& batch = *message.mutable_input();
    batch.set_first_sequence(7);
    batch.set_client_time_us(99);
    batch.mutable_ack()->set_frame(5);
    v1::SpawnInput& spawn = *batch.add_inputs()->mutable_spawn();
    spawn.mutable_shape()->mutable_capsule()->set_radius(0.25);
    spawn.mutable_shape()->mutable_capsule()->set_half_length(0.5);
    spawn.mutable_shape()->set_density(300);
    spawn.mutable_position()->set_y(2);
    spawn.mutable_rotation()->set_z(2);  // not a unit quaternion
    spawn.set_color(0x12345678);
    v1::ImpulseInput& push = *batch.add_inputs()->mutable_impulse();
    push.set_entity(3);
    push.mutable_impulse()->set_x(-1);
    batch.mutable_inputs(1)->set_tick(70);
    batch.add_inputs()->mutable_grab()->set_entity(4);
    batch.add_inputs()->mutable_drag()->mutable_target()->set_z(6);
    batch.add_inputs()->mutable_release();
    batch.add_inputs()->mutable_delete_()->set_entity(8);
    batch.add_inputs()->mutable_explode()->set_radius(2.5);
    batch.add_inputs()->mutable_possess()->set_entity(9);
    v1::ControlInput& control = *batch.add_inputs()->mutable_control();
    control.add_axes(-1000);
    control.add_axes(250);
    control.set_buttons(5);
    for (int k = 0; k < 9; k++) {
        if (k == 0) batch.add_inputs();
        batch.mutable_inputs(9)->mutable_control()->add_axes(k);
    }
    batch.add_inputs();  // an input without a kind

    const auto decoded = decode_as<InputBatch>(message);
    EXPECT_EQ(decoded.first_sequence, 7u);
    EXPECT_EQ(decoded.client_time_us, 99u);
    EXPECT_EQ(decoded.ack->frame, 5u);
    ASSERT_EQ(decoded.inputs.size(), 11u);
    ASSERT_EQ(decoded.ticks.size(), 11u);
    EXPECT_EQ(decoded.ticks[0], 0u) << "0 means the next tick";
    EXPECT_EQ(decoded.ticks[1], 70u);
    const auto& spawned = std::get<SpawnCommand>(*decoded.inputs[0]);
    EXPECT_EQ(spawned.shape.geometry, physics::Geometry(physics::Capsule{0.25, 0.5}));
    EXPECT_EQ(spawned.shape.density, 300);
    EXPECT_EQ(spawned.shape.material, physics::Material{})
        << "absent fields must have their defaults";
    EXPECT_EQ(spawned.pose.position, (physics::Vec3{0, 2, 0}));
    EXPECT_EQ(spawned.pose.rotation, (physics::Quat{0, 0, 1, 0}));
    EXPECT_EQ(spawned.color, 0x345678u);
    const auto& pushed = std::get<ImpulseCommand>(*decoded.inputs[1]);
    EXPECT_EQ(pushed.entity, 3u);
    EXPECT_EQ(pushed.impulse.x, -1);
    EXPECT_FALSE(pushed.point) << "an absent point means the centre of mass";
    EXPECT_EQ(std::get<GrabCommand>(*decoded.inputs[2]).entity, 4u);
    EXPECT_EQ(std::get<DragCommand>(*decoded.inputs[3]).target.z, 6);
    EXPECT_TRUE(std::holds_alternative<ReleaseCommand>(*decoded.inputs[4]));
    EXPECT_EQ(std::get<DeleteCommand>(*decoded.inputs[5]).entity, 8u);
    EXPECT_EQ(std::get<ExplodeCommand>(*decoded.inputs[6]).radius, 2.5);
    EXPECT_EQ(std::get<PossessCommand>(*decoded.inputs[7]).entity, 9u);
    const physics::Controls& held = std::get<ControlCommand>(*decoded.inputs[8]).controls;
    EXPECT_EQ(held, (physics::Controls{.axes = {-1, 0.25}, .buttons = 5}));
    EXPECT_FALSE(decoded.inputs[9].ok()) << "nine axes must be rejected";
    EXPECT_FALSE(decoded.inputs[10].ok()) << "an invalid input must not affect the others";
}

TEST(ClientMessage, decodes_inputs_that_build) {
    v1::ClientMessage message;
    v1::InputBatch& batch = *message.mutable_input();
    batch.set_first_sequence(1);
    v1::EditInput& edit = *batch.add_inputs()->mutable_edit();
    edit.set_entity(3);
    edit.mutable_rotation()->set_w(2);  // not a unit quaternion
    edit.set_friction(0);
    edit.set_color(0x12345678);
    edit.set_frozen(false);
    v1::CloneInput& clone = *batch.add_inputs()->mutable_clone();
    clone.set_entity(4);
    clone.mutable_offset()->set_y(2);
    clone.set_jointed(true);
    v1::CreateJointInput& hinge = *batch.add_inputs()->mutable_create_joint();
    hinge.set_entity_b(5);
    hinge.mutable_joint()->mutable_frame()->mutable_position()->set_x(1.5);
    hinge.mutable_joint()->mutable_hinge()->set_motor_speed(3);
    hinge.mutable_joint()->mutable_hinge()->set_motor_max_torque(40);
    hinge.mutable_joint()->set_break_force(900);
    batch.add_inputs()->mutable_delete_joint()->set_joint(7);
    batch.add_inputs()->mutable_undo();
    batch.add_inputs()->mutable_room()->mutable_step();
    batch.add_inputs()->mutable_room()->mutable_speed()->set_percent(25);
    batch.add_inputs()->mutable_room()->mutable_rewind()->set_tick(99);

    const auto decoded = decode_as<InputBatch>(message);
    ASSERT_EQ(decoded.inputs.size(), 8u);
    for (const auto& input : decoded.inputs) ASSERT_TRUE(input.ok()) << input.error().message;
    const auto& edited = std::get<EditCommand>(*decoded.inputs[0]);
    EXPECT_EQ(edited.entity, 3u);
    EXPECT_EQ(edited.rotation, physics::Quat{});
    EXPECT_EQ(edited.friction, 0);
    EXPECT_EQ(edited.color, 0x345678u);
    EXPECT_EQ(edited.frozen, false);
    EXPECT_EQ(edited.position, std::nullopt);
    EXPECT_EQ(edited.mass, std::nullopt);
    const auto& cloned = std::get<CloneCommand>(*decoded.inputs[1]);
    EXPECT_EQ(cloned.offset.y, 2);
    EXPECT_TRUE(cloned.jointed);
    const auto& joint = std::get<CreateJointCommand>(*decoded.inputs[2]);
    EXPECT_EQ(joint.entity_a, 0u);
    ASSERT_TRUE(joint.frame);
    EXPECT_EQ(joint.frame->position.x, 1.5);
    EXPECT_EQ(std::get<physics::HingeJoint>(joint.joint.kind).motor.speed, 3);
    EXPECT_EQ(joint.joint.break_force, 900);
    EXPECT_EQ(std::get<DeleteJointCommand>(*decoded.inputs[3]).joint, 7u);
    const auto& room = [&](std::size_t at) -> const RoomCommand& {
        return std::get<RoomCommand>(*decoded.inputs[at]);
    };
    EXPECT_EQ(std::get<StepRoom>(room(5).kind).steps, 1u);
    EXPECT_EQ(std::get<SetRoomSpeed>(room(6).kind).percent, 25u);
    EXPECT_EQ(std::get<RewindRoom>(room(7).kind).tick, 99u);
}

// The error of one input, from its decoding or from the check of its numbers.
std::string error_of_input(const v1::Input& input) {
    v1::ClientMessage message;
    message.mutable_input()->set_first_sequence(1);
    *message.mutable_input()->add_inputs() = input;
    const auto decoded = decode_as<InputBatch>(message);
    const auto& action = decoded.inputs.at(0);
    if (!action.ok()) return action.error().message;
    const Status checked = check_numbers(*action);
    return checked.ok() ? "" : checked.error().message;
}

TEST(ClientMessage, hostile_edits_and_joints_are_refused_with_their_field) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto edit = [](auto change) {
        v1::Input input;
        change(*input.mutable_edit());
        return error_of_input(input);
    };
    EXPECT_EQ(edit([](v1::EditInput& e) { e.set_mass(1e7); }),
              "edit.mass is 1e+07; it must be from 0.001 to 1e+06");
    EXPECT_EQ(edit([&](v1::EditInput& e) { e.set_friction(nan); }),
              "edit.friction is nan; it must be from 0 to 10");
    EXPECT_EQ(edit([](v1::EditInput& e) { e.set_mass(1), e.set_density(1); }),
              "edit.mass and edit.density are both set; set one of them");
    EXPECT_EQ(edit([](v1::EditInput& e) { e.mutable_linear_velocity()->set_x(51); }),
              "edit.linear_velocity is 51 long; at most 50 is allowed");
    EXPECT_NE(edit([&](v1::EditInput& e) { e.mutable_position()->set_y(nan); }), "");
    EXPECT_NE(edit([&](v1::EditInput& e) { e.mutable_rotation()->set_y(nan); }), "");
    EXPECT_NE(edit([](v1::EditInput& e) { e.set_gravity_scale(11); }), "");
    EXPECT_NE(edit([](v1::EditInput& e) { e.set_restitution(-0.1); }), "");
    EXPECT_NE(edit([](v1::EditInput& e) { e.set_density(0.5); }), "");

    const auto joint = [](auto change) {
        v1::Input input;
        input.mutable_create_joint()->set_entity_b(2);
        change(*input.mutable_create_joint()->mutable_joint());
        return error_of_input(input);
    };
    EXPECT_EQ(joint([](v1::Joint& j) { j.mutable_ball(); }), "");
    EXPECT_TRUE(joint([](v1::Joint&) {}).starts_with("create_joint.joint: has no kind"));
    EXPECT_EQ(joint([](v1::Joint& j) { j.mutable_gear(); }),
              "create_joint.joint is a gear joint; allowed are ball, hinge, slider, fixed and "
              "distance");
    EXPECT_EQ(joint([](v1::Joint& j) {
                  j.mutable_hinge()->set_motor_speed(101);
                  j.mutable_hinge()->set_motor_max_torque(1);
              }),
              "create_joint.joint.hinge.motor_speed is 101; it must be from -100 to 100");
    EXPECT_NE(joint([](v1::Joint& j) {
                  j.mutable_slider()->set_motor_speed(1);
                  j.mutable_slider()->set_motor_max_force(1e7);
              }),
              "");
    EXPECT_NE(joint([](v1::Joint& j) {
                  j.mutable_distance()->mutable_spring()->set_hertz(61);
                  j.mutable_distance()->set_max_length(1);
              }),
              "");
    EXPECT_NE(joint([&](v1::Joint& j) {
                  j.mutable_ball();
                  j.mutable_frame()->mutable_position()->set_x(nan);
              }),
              "");
    EXPECT_NE(joint([](v1::Joint& j) {
                  j.mutable_ball();
                  j.mutable_frame_b()->mutable_position()->set_z(2e4);
              }),
              "");
    EXPECT_NE(joint([](v1::Joint& j) { j.mutable_ball(), j.set_name("x"); }), "");
    EXPECT_NE(joint([](v1::Joint& j) { j.mutable_ball(), j.mutable_repeat()->set_count(9); }), "");
    EXPECT_NE(joint([](v1::Joint& j) { j.mutable_ball(), j.mutable_frame(), j.mutable_frame_a(); }),
              "");
    EXPECT_NE(joint([](v1::Joint& j) { j.mutable_ball(), j.set_break_force(-1); }), "");

    const auto room = [](auto change) {
        v1::Input input;
        change(*input.mutable_room());
        return error_of_input(input);
    };
    EXPECT_EQ(room([](v1::RoomInput& r) { r.mutable_speed()->set_percent(7); }),
              "speed.percent is 7; it must be a multiple of 5 from 5 to 100");
    EXPECT_NE(room([](v1::RoomInput& r) { r.mutable_speed()->set_percent(0); }), "");
    EXPECT_NE(room([](v1::RoomInput& r) { r.mutable_step()->set_steps(61); }), "");
    EXPECT_EQ(room([](v1::RoomInput& r) { r.mutable_settings()->set_timeline_seconds(61); }),
              "room.timeline_seconds is 61; it must be from 0 to 60");
}

TEST(ClientMessage, rejects_malformed_messages) {
    EXPECT_FALSE(decode_client_message("\xff\xff\xff").ok());
    EXPECT_FALSE(decode_client_message("").ok());
    v1::ClientMessage long_name;
    long_name.mutable_hello()->set_name(std::string(33, 'x'));
    EXPECT_NE(refusal_of(long_name).find("hello.name has 33 bytes"), std::string::npos);
    v1::ClientMessage from_zero;
    from_zero.mutable_input()->add_inputs()->mutable_release();
    EXPECT_NE(refusal_of(from_zero).find("first_sequence is 0"), std::string::npos);
    v1::ClientMessage beyond;
    beyond.mutable_input()->set_first_sequence(0xffffffff);
    beyond.mutable_input()->add_inputs()->mutable_release();
    EXPECT_NE(refusal_of(beyond).find("leaves no sequence numbers"), std::string::npos);
}

TEST(ClientMessage, rejects_a_precision_out_of_range_with_its_name_and_range) {
    v1::ClientMessage message;
    v1::Precision& precision = *message.mutable_hello()->mutable_precision();
    precision.set_position(0.01);
    precision.set_rotation(0.001);
    EXPECT_EQ(decode_as<Hello>(message).precision,
              (StreamPrecision{{.position_m = 0.01, .rotation_rad = 0.001}, 0}));
    precision.set_far_factor(0.5);
    EXPECT_EQ(refusal_of(message),
              "hello.precision.far_factor is 0.5; it must be 0 or from 1 to 1000");
    precision.set_far_factor(1);
    precision.set_position(2);
    EXPECT_EQ(refusal_of(message), "hello.precision.position is 2; it must be from 0.0001 to 1 m");
    precision.set_position(0.01);
    precision.set_rotation(std::nan(""));
    EXPECT_NE(refusal_of(message).find("hello.precision.rotation is"), std::string::npos);
}

TEST(ClientMessage, rejects_inputs_with_non_finite_rotation) {
    for (const double bad :
         {std::nan(""), std::numeric_limits<double>::infinity(), 1e200, 1e-200}) {
        v1::ClientMessage message;
        message.mutable_input()->set_first_sequence(1);
        v1::SpawnInput& spawn = *message.mutable_input()->add_inputs()->mutable_spawn();
        spawn.mutable_shape()->mutable_sphere()->set_radius(1);
        spawn.mutable_rotation()->set_x(bad);
        const auto decoded = decode_as<InputBatch>(message);
        // The square of 1e-200 is zero: the rotation is absent, which is valid.
        EXPECT_EQ(decoded.inputs[0].ok(), bad == 1e-200) << bad;
    }
}

}  // namespace
}  // namespace jostle::server
