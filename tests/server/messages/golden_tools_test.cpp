// SPDX-License-Identifier: MIT
//
// proto/golden/sandbox_tools.jmsg: clients write and read these bytes, and the server reads and
// writes them.
#include "tests/server/messages/golden_tools.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <variant>

#include "server/limits/admission.h"
#include "server/messages/client_message.h"

namespace jostle::server {
namespace {

template <class Kind>
const Kind& as(const Result<Action>& action) {
    return std::get<Kind>(*action);
}

template <class Kind>
const Kind& about_room(const Result<Action>& action) {
    return std::get<Kind>(as<RoomCommand>(action).kind);
}

TEST(GoldenTools, are_the_committed_bytes) {
    std::ifstream in(std::string(GOLDEN_FOLDER) + "/sandbox_tools.jmsg", std::ios::binary);
    const std::string golden{std::istreambuf_iterator<char>(in), {}};
    EXPECT_EQ(golden_tools(), golden)
        << "only if the protocol changes: golden_tools proto/golden/sandbox_tools.jmsg";
}

TEST(GoldenTools, server_reads_the_inputs_that_wire_md_lists) {
    const auto message = decode_client_message(golden_tool_inputs().SerializeAsString());
    ASSERT_TRUE(message.ok());
    const auto& batch = std::get<InputBatch>(*message);
    EXPECT_EQ(batch.first_sequence, 7u);
    ASSERT_EQ(batch.inputs.size(), 8u);
    for (const Result<Action>& input : batch.inputs) {
        ASSERT_TRUE(input.ok()) << input.error().message;
        EXPECT_TRUE(check_numbers(*input).ok());
    }
    const auto& edit = as<EditCommand>(batch.inputs[0]);
    EXPECT_EQ(edit.entity, 12u);
    EXPECT_EQ(*edit.position, (physics::Vec3{1.5, -2, 0.25}));
    EXPECT_EQ(edit.rotation->y, 1);
    EXPECT_EQ(edit.linear_velocity->y, 4);
    EXPECT_EQ(edit.angular_velocity->x, -0.5);
    EXPECT_EQ(edit.mass, 20);
    EXPECT_FALSE(edit.density.has_value());
    EXPECT_EQ(edit.friction, 0) << "present, and 0";
    EXPECT_EQ(edit.restitution, 0.75);
    EXPECT_EQ(edit.color, 0xff8000u);
    EXPECT_EQ(edit.frozen, false) << "present, and false";
    EXPECT_EQ(edit.gravity_scale, -0.5);
    const auto& clone = as<CloneCommand>(batch.inputs[1]);
    EXPECT_EQ(clone.offset, (physics::Vec3{2, 0, -1}));
    EXPECT_TRUE(clone.jointed);
    const auto& create = as<CreateJointCommand>(batch.inputs[2]);
    EXPECT_EQ(create.entity_a, 0u);
    EXPECT_EQ(create.entity_b, 12u);
    EXPECT_EQ(create.frame->position.y, 3);
    const auto& hinge = std::get<physics::HingeJoint>(create.joint.kind);
    EXPECT_EQ(hinge.limit.upper, 1.25);
    EXPECT_EQ(hinge.motor.max_torque, 300);
    EXPECT_TRUE(create.joint.collide_connected);
    EXPECT_EQ(create.joint.break_force, 5000);
    EXPECT_EQ(as<DeleteJointCommand>(batch.inputs[3]).joint, 300u);
    EXPECT_TRUE(std::holds_alternative<UndoCommand>(*batch.inputs[4]));
    EXPECT_EQ(about_room<StepRoom>(batch.inputs[5]).steps, 60u);
    EXPECT_EQ(about_room<SetRoomSpeed>(batch.inputs[6]).percent, 25u);
    EXPECT_EQ(about_room<RewindRoom>(batch.inputs[7]).tick, 1234u);
}

TEST(GoldenTools, inspection_has_the_values_that_wire_md_lists) {
    const v1::InspectedBody body = golden_inspections()[0].body();
    EXPECT_EQ(body.kinetic_energy(), 0.5 * 20 * 4 + 0.5 * 32 * 16);
    EXPECT_EQ(body.inertia_z().z(), 32);
    EXPECT_EQ(body.contact_count(), 300u);
    EXPECT_EQ(body.contacts(0).points(0).impulse(), 3.25);
    EXPECT_EQ(body.joints(0).force(), 5);
    EXPECT_EQ(body.joints(0).torque(), 2);
    EXPECT_EQ(body.joints(0).coordinate(), 0.5) << "the angle of the hinge, rad";
    const v1::InspectedJoint joint = golden_inspections()[1].joint();
    EXPECT_EQ(joint.joint().break_force(), 5000);
    EXPECT_EQ(joint.anchor_b().y(), 3.0009765625);
}

}  // namespace
}  // namespace jostle::server
