// SPDX-License-Identifier: MIT
#include "protocol/convert.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "jostle/v1/play.pb.h"

namespace jostle::server {
namespace {

template <class Words>
Words read_as(const v1::ClientMessage& message) {
    const auto words = decode_client_message(message.SerializeAsString());
    EXPECT_TRUE(words.ok()) << words.error().message;
    return std::get<Words>(*words);
}

template <class Message = v1::ServerMessage>
Message parse(const std::string& bytes) {
    Message message;
    EXPECT_TRUE(message.ParseFromString(bytes));
    return message;
}

std::string refusal_of(const v1::ClientMessage& message) {
    const auto words = decode_client_message(message.SerializeAsString());
    return words.ok() ? "" : words.error().message;
}

TEST(Convert, reads_each_kind_of_input) {
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
    spawn.mutable_rotation()->set_z(2);  // not of unit length
    spawn.set_color(0x12345678);
    v1::ImpulseInput& push = *batch.add_inputs()->mutable_impulse();
    push.set_entity(3);
    push.mutable_impulse()->set_x(-1);
    batch.add_inputs()->mutable_grab()->set_entity(4);
    batch.add_inputs()->mutable_drag()->mutable_target()->set_z(6);
    batch.add_inputs()->mutable_release();
    batch.add_inputs()->mutable_delete_()->set_entity(8);
    batch.add_inputs()->mutable_explode()->set_radius(2.5);
    batch.add_inputs();  // of no kind

    const auto words = read_as<InputBatch>(message);
    EXPECT_EQ(words.first_sequence, 7u);
    EXPECT_EQ(words.client_time_us, 99u);
    EXPECT_EQ(words.ack->frame, 5u);
    ASSERT_EQ(words.inputs.size(), 8u);
    const auto& spawned = std::get<SpawnCommand>(*words.inputs[0]);
    EXPECT_EQ(spawned.shape.geometry, physics::Geometry(physics::Capsule{0.25, 0.5}));
    EXPECT_EQ(spawned.shape.density, 300);
    EXPECT_EQ(spawned.shape.material, physics::Material{}) << "what is absent has its default";
    EXPECT_EQ(spawned.pose.position, (physics::Vec3{0, 2, 0}));
    EXPECT_EQ(spawned.pose.rotation, (physics::Quat{0, 0, 1, 0}));
    EXPECT_EQ(spawned.color, 0x345678u);
    const auto& pushed = std::get<ImpulseCommand>(*words.inputs[1]);
    EXPECT_EQ(pushed.entity, 3u);
    EXPECT_EQ(pushed.impulse.x, -1);
    EXPECT_FALSE(pushed.point) << "absent: the centre of mass";
    EXPECT_EQ(std::get<GrabCommand>(*words.inputs[2]).entity, 4u);
    EXPECT_EQ(std::get<DragCommand>(*words.inputs[3]).target.z, 6);
    EXPECT_TRUE(std::holds_alternative<ReleaseCommand>(*words.inputs[4]));
    EXPECT_EQ(std::get<DeleteCommand>(*words.inputs[5]).entity, 8u);
    EXPECT_EQ(std::get<ExplodeCommand>(*words.inputs[6]).radius, 2.5);
    EXPECT_FALSE(words.inputs[7].ok()) << "one bad input refuses itself alone";
}

TEST(Convert, refuses_what_is_no_message) {
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
    EXPECT_NE(refusal_of(beyond).find("no numbers"), std::string::npos);
}

TEST(Convert, a_rotation_that_is_no_number_refuses_its_input) {
    for (const double bad :
         {std::nan(""), std::numeric_limits<double>::infinity(), 1e200, 1e-200}) {
        v1::ClientMessage message;
        message.mutable_input()->set_first_sequence(1);
        v1::SpawnInput& spawn = *message.mutable_input()->add_inputs()->mutable_spawn();
        spawn.mutable_shape()->mutable_sphere()->set_radius(1);
        spawn.mutable_rotation()->set_x(bad);
        const auto words = read_as<InputBatch>(message);
        // 1e-200 squared is zero: no rotation, which is fine.
        EXPECT_EQ(words.inputs[0].ok(), bad == 1e-200) << bad;
    }
}

TEST(Convert, a_snapshot_is_its_two_pieces_one_after_the_other) {
    const EncodedSnapshot encoded{.frame = 300,
                                  .bases = {299, 298, 297},
                                  .packed = {std::byte{1}, std::byte{0}, std::byte{255}},
                                  .crc = 0xdeadbeef,
                                  .due = Clock::time_point(std::chrono::microseconds(123456))};
    const std::string shared = encode_shared_snapshot(encoded);
    for (const Private own : {Private{}, Private{0xffffffff, 0xffffffff, 0xffffffff}}) {
        const auto message = parse(encode_snapshot_head(own, shared.size()) + shared);
        ASSERT_TRUE(message.has_snapshot());
        const v1::Snapshot& snapshot = message.snapshot();
        EXPECT_EQ(snapshot.frame(), 300u);
        EXPECT_EQ(snapshot.base_frame(), 299u);
        EXPECT_EQ(snapshot.base3_frame(), 297u);
        EXPECT_EQ(snapshot.packed(), std::string("\x01\x00\xff", 3));
        EXPECT_EQ(snapshot.crc(), 0xdeadbeef);
        EXPECT_EQ(snapshot.server_time_us(), 123456u);
        EXPECT_EQ(snapshot.own().input_sequence(), own.input_sequence);
        EXPECT_EQ(snapshot.own().echo_client_time_us(), own.echo_client_time_us);
        EXPECT_EQ(snapshot.own().snapshots_skipped(), own.snapshots_skipped);
    }
}

TEST(Convert, a_roster_carries_what_a_viewer_draws) {
    EntityDescription box{.id = 9,
                          .type = physics::BodyType::kinematic,
                          .shapes = {},
                          .owner = 4,
                          .color = 0xff8800,
                          .name = "lift",
                          .mass = 12};
    physics::ShapeState shape;
    shape.geometry = physics::Box{{1, 2, 3}};
    shape.pose.position = {0, 5, 0};
    box.shapes.push_back(shape);
    const std::vector added{std::make_shared<const EntityDescription>(box)};
    const std::vector<EntityId> removed{2, 3};
    const auto message = parse(encode_roster(added, removed));
    const v1::Roster& roster = message.roster();
    ASSERT_EQ(roster.added_size(), 1);
    const v1::Entity& entity = roster.added(0);
    EXPECT_EQ(entity.id(), 9u);
    EXPECT_EQ(entity.type(), v1::BODY_TYPE_KINEMATIC);
    EXPECT_EQ(entity.owner(), 4u);
    EXPECT_EQ(entity.color(), 0xff8800u);
    EXPECT_EQ(entity.name(), "lift");
    EXPECT_EQ(entity.mass(), 12);
    EXPECT_EQ(entity.shapes(0).box().half_extents().z(), 3);
    EXPECT_EQ(entity.shapes(0).position().y(), 5);
    EXPECT_EQ(roster.removed_size(), 2);
    EXPECT_EQ(roster.removed(1), 3u);
}

TEST(Convert, results_and_notices_keep_code_and_words) {
    const InputResult refused{.sequence = 5,
                              .status = Error{ErrorCode::permission_denied, "not yours"},
                              .tick = 77,
                              .entity = 6};
    const auto results = parse(encode_input_results(std::span(&refused, 1)));
    const v1::InputResult& result = results.input_results().results(0);
    EXPECT_EQ(result.sequence(), 5u);
    EXPECT_EQ(result.code(), v1::INPUT_CODE_NOT_ALLOWED);
    EXPECT_EQ(result.tick(), 77u);
    EXPECT_EQ(result.entity(), 6u);
    EXPECT_EQ(result.message(), "not yours");
    const auto notice = parse(encode_notice(NoticeKind::world_closed, "bye"));
    EXPECT_EQ(notice.notice().code(), v1::NOTICE_CODE_WORLD_CLOSED);
    EXPECT_EQ(notice.notice().message(), "bye");
}

}  // namespace
}  // namespace jostle::server
