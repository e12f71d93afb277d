// SPDX-License-Identifier: MIT
#include "server/recovery/journal_codec.h"

#include <gtest/gtest.h>

#include "jostle/physics/hull.h"
#include "jostle/physics/serialization.h"
#include "jostle/scenes/catalog.h"
#include "jostle/scenes/shape_message.h"
#include "server/world/hosted_world.h"
#include "tests/support/error_of.h"
#include "tests/support/random.h"
#include "tests/support/step_time.h"

namespace jostle::server {
namespace {

using test::dt;
using test::error_of;

HostedWorld sandbox() {
    return std::move(*HostedWorld::create(
        *scenes::find_scene("sandbox"),
        {.scene = {.bodies_max = 400}, .bodies_owned_max = 30, .lag_compensation_ms_max = 250}, 1));
}

// A hull as a client sends it: decoded from its message.
SpawnCommand stone(test::Random& random) {
    std::vector<physics::Vec3> points;
    for (int k = 0; k < 14; k++) points.push_back(random.vector(0.4));
    SpawnCommand spawn;
    const physics::ShapeDef def{.geometry = physics::Hull{*physics::build_hull(points)}};
    spawn.shape_bytes = scenes::shape_bytes(def);
    spawn.shape = *scenes::shape_from_bytes(spawn.shape_bytes, "shape");
    spawn.pose = {random.vector(4) + physics::Vec3{0, 7, 0}, random.rotation()};
    spawn.angular_velocity = random.vector(5);
    spawn.color = 0x806040;
    return spawn;
}

Action any_action(test::Random& random) {
    const auto entity = static_cast<EntityId>(1 + random.below(120));
    const Aim aim{random.vector(9) + physics::Vec3{0, 9, 0}, random.vector(20)};
    const Action actions[] = {
        stone(random),
        ImpulseCommand{entity, random.vector(30), random.vector(3)},
        ImpulseCommand{0, random.vector(30), {}, aim},
        GrabCommand{entity, random.vector(3)},
        GrabCommand{0, {}, aim},
        CutCommand{.point_object = 3},
        DragCommand{random.vector(5)},
        ReleaseCommand{},
        DeleteCommand{entity},
        ExplodeCommand{random.vector(6), 4, 6},
        ExplodeCommand{{}, 4, 6, aim},
        PossessCommand{entity},
        ControlCommand{{.axes = {0.5, -1}, .buttons = 3}},
        DisconnectCommand{},
        JoinCommand{"name", PlayerRole::builder, 0x123456, 5},
        RenameCommand{"other name"},
        SetRoleCommand{1, PlayerRole::owner},
        SetAttributesCommand{{AttributeTargetKind::entity, entity},
                             {{"key", random.vector(3)}, {"gone", {}}}},
        SetAttributesCommand{{AttributeTargetKind::player, 2}, {{"text", std::string("value")}}},
        SendMessageCommand{"chat", "hello", {1, 3}},
        EditCommand{.entity = entity,
                    .position = random.vector(5) + physics::Vec3{0, 6, 0},
                    .density = 500.0,
                    .restitution = 0.5,
                    .color = 0xff},
        EditCommand{.entity = entity,
                    .rotation = random.rotation(),
                    .linear_velocity = random.vector(9),
                    .angular_velocity = random.vector(9),
                    .mass = 7.0,
                    .friction = 0.9,
                    .gravity_scale = 0.5},
        EditCommand{.entity = entity, .frozen = random.below(2) == 0},
        CloneCommand{entity, random.vector(4) + physics::Vec3{0, 5, 0}, random.below(2) == 0},
        CreateJointCommand{
            entity,
            static_cast<EntityId>(1 + random.below(120)),
            physics::Transform{random.vector(4), random.rotation()},
            {.kind = physics::HingeJoint{.limit = {true, -0.5, 0.25}, .motor = {true, 2, 50}},
             .break_force = 1e5}},
        CreateJointCommand{
            0,
            entity,
            {},
            {.frame_a = {random.vector(4), random.rotation()},
             .frame_b = {random.vector(0.2), {}},
             .kind =
                 physics::DistanceJoint{
                     .min_length = 0, .max_length = 3, .spring = {2, 0.3}, .rest_length = 1}}},
        DeleteJointCommand{.target = {entity % 40, 0}},
        DeleteJointCommand{.joint = entity % 20 + 1},
        UndoCommand{},
        LeaveCommand{random.below(2) == 0}};
    return actions[random.below(std::size(actions))];
}

// Four players for `ticks` ticks. Returns their inputs as a journal segment.
JournalSegment play(HostedWorld& world, std::uint32_t ticks) {
    world.enable_journal();
    test::Random random(77);
    JournalSegment journal{{}, {{3, 3}, {90, 94}}};
    for (std::uint32_t tick = 1; tick <= ticks; tick++) {
        for (ClientId client = 1; client <= 4; client++) {
            const Action action = any_action(random);
            world.apply({.client = client,
                         .sequence = is_session_command(action) ? 0 : tick,
                         .action = action,
                         .reply = {}},
                        tick);
        }
        journal.ticks.push_back({tick, world.take_journal()});
        EXPECT_TRUE(world.step(dt, tick).ok());
    }
    return journal;
}

TEST(JournalCodec, replay_reproduces_the_world) {
    HostedWorld world = sandbox();
    const JournalSegment journal = play(world, 150);
    const std::string bytes = encode_journal(journal);
    const auto decoded = decode_journal(bytes);
    ASSERT_TRUE(decoded.ok()) << decoded.error().message;

    HostedWorld again = sandbox();
    std::size_t aimed = 0, missed = 0;
    EXPECT_EQ(decoded->paused_ticks, journal.paused_ticks);
    for (const JournaledTick& tick : decoded->ticks) {
        for (const JournaledCommand& command : tick.commands) {
            again.replay(command);
            (command.action ? aimed : missed)++;
        }
        ASSERT_TRUE(again.step(dt, tick.tick).ok());
    }
    EXPECT_EQ(physics::state_hash(again.world()), physics::state_hash(world.world()));
    EXPECT_EQ(encode_host_state(again.host_state(150)), encode_host_state(world.host_state(150)));
    EXPECT_GT(aimed, 400u);
    EXPECT_GT(missed, 10u) << "rays without a hit must be included";
    EXPECT_LT(bytes.size(), 600u * 200) << "at most 200 bytes per command";
}

TEST(JournalCodec, rewind_is_a_separate_entry_absent_from_version_2) {
    const std::string bytes =
        encode_journal({.ticks = {}, .paused_ticks = {}, .rewind = Rewind{.tick = 90, .to = 30}});
    EXPECT_EQ(decode_journal(bytes).value().rewind, (Rewind{.tick = 90, .to = 30}));
    EXPECT_EQ(
        error_of(decode_journal(encode_journal(
                     {.ticks = {}, .paused_ticks = {}, .rewind = Rewind{.tick = 9, .to = 9}})))
            .message,
        "corrupt journal record: invalid rewind from tick 9 to tick 9");
    EXPECT_EQ(error_of(decode_journal(encode_journal(
                           {.ticks = {}, .paused_ticks = {{8, 9}}, .rewind = Rewind{9, 3}})))
                  .code,
              ErrorCode::corrupt_data);
    const char version_2[] = {2, 0, 1, 3, 4};  // no commands; ticks 3 and 4 were paused
    const JournalSegment old = decode_journal({version_2, sizeof version_2}).value();
    EXPECT_EQ(old.paused_ticks, (std::vector<TickRange>{{3, 4}}));
    EXPECT_FALSE(old.rewind);
}

TEST(JournalCodec, undo_is_a_separate_entry_of_version_4) {
    const Undo undo{.tick = 90, .first_tick = 30, .client = 7};
    const std::string bytes =
        encode_journal({.ticks = {}, .paused_ticks = {}, .rewind = {}, .undo = undo});
    EXPECT_EQ(bytes[0], 4);
    EXPECT_EQ(decode_journal(bytes).value().undo, undo);
    EXPECT_EQ(encode_journal({})[0], 3) << "older servers read a journal without undos";
    const auto code_of = [](const JournalSegment& segment) {
        return error_of(decode_journal(encode_journal(segment))).code;
    };
    EXPECT_EQ(code_of({.ticks = {}, .paused_ticks = {}, .rewind = {}, .undo = Undo{9, 9, 7}}),
              ErrorCode::corrupt_data);
    EXPECT_EQ(code_of({.ticks = {}, .paused_ticks = {{8, 9}}, .rewind = {}, .undo = undo}),
              ErrorCode::corrupt_data);
}

TEST(JournalCodec, targets_on_ropes_and_cloths_need_version_5) {
    const DeformableTarget target{"rope", 3, 14};
    const JournalSegment written{
        .ticks = {{4,
                   {{1, 1, GrabCommand{.point = {1, 2, 3}, .deformable = target}},
                    {1, 2, GrabCommand{.entity = 5, .point = {1, 2, 3}}},
                    {2, 1, CutCommand{.point = {4, 5, 6}, .deformable = target}}}}},
        .paused_ticks = {}};
    const std::string bytes = encode_journal(written);
    EXPECT_EQ(bytes[0], 5);
    const JournalSegment read = decode_journal(bytes).value();
    const auto& commands = read.ticks.at(0).commands;
    EXPECT_EQ(std::get<GrabCommand>(*commands.at(0).action).deformable, target);
    EXPECT_EQ(std::get<GrabCommand>(*commands.at(1).action).deformable, std::nullopt);
    EXPECT_EQ(std::get<GrabCommand>(*commands.at(1).action).entity, 5u);
    EXPECT_EQ(std::get<CutCommand>(*commands.at(2).action).deformable, target);
    EXPECT_EQ(std::get<CutCommand>(*commands.at(2).action).point, (physics::Vec3{4, 5, 6}));
    EXPECT_FALSE(read.undo);
}

TEST(JournalCodec, room_commands_need_version_7) {
    const JournalSegment written{
        .ticks = {{4,
                   {{1, 0, RoomCommand{EnterRoom{"subject/ada", false, false}}},
                    {1, 1, CutCommand{.deformable = DeformableTarget{"rope", 3, 14}}},
                    {1, 2, RoomCommand{BanClient{7, 2.5, "spam"}}}}}},
        .paused_ticks = {}};
    const std::string bytes = encode_journal(written);
    EXPECT_EQ(bytes[0], 7);
    const JournalSegment read = decode_journal(bytes).value();
    const auto& commands = read.ticks.at(0).commands;
    const auto room_command = [&](std::size_t index) {
        return std::get<RoomCommand>(*commands.at(index).action);
    };
    EXPECT_EQ(std::get<EnterRoom>(room_command(0).kind).member, "subject/ada");
    EXPECT_EQ(std::get<BanClient>(room_command(2).kind).seconds, 2.5);
    for (std::size_t size = 0; size < bytes.size(); size++)
        EXPECT_FALSE(decode_journal(bytes.substr(0, size)).ok());
}

TEST(JournalCodec, edits_and_joints_need_version_8) {
    const physics::JointDef hinge{.frame_b = {{0, 0.5, 0}, {}},
                                  .kind = physics::HingeJoint{.motor = {true, 2, 50}},
                                  .collide_connected = true,
                                  .break_torque = 40};
    const JournalSegment written{
        .ticks = {{4,
                   {{1, 1, EditCommand{.entity = 7, .friction = 0.25, .frozen = true}},
                    {1, 2, CloneCommand{7, {1, 2, 3}, true}},
                    {1, 3, CreateJointCommand{0, 7, physics::Transform{{1, 2, 3}, {}}, hinge}},
                    {1, 4, CreateJointCommand{7, 8, {}, hinge}},
                    {1, 5, DeleteJointCommand{.joint = 3, .target = {11, 2}}},
                    {1, 6, UndoCommand{}}}}},
        .paused_ticks = {}};
    const std::string bytes = encode_journal(written);
    EXPECT_EQ(bytes[0], 8);
    const JournalSegment read = decode_journal(bytes).value();
    const auto& commands = read.ticks.at(0).commands;
    const auto& edit = std::get<EditCommand>(*commands.at(0).action);
    EXPECT_EQ(edit.friction, 0.25);
    EXPECT_EQ(edit.frozen, true);
    EXPECT_EQ(edit.mass, std::nullopt);
    EXPECT_TRUE(std::get<CloneCommand>(*commands.at(1).action).jointed);
    const auto& framed = std::get<CreateJointCommand>(*commands.at(2).action);
    ASSERT_TRUE(framed.frame);
    EXPECT_EQ(framed.frame->position, (physics::Vec3{1, 2, 3}));
    const auto& joint = std::get<CreateJointCommand>(*commands.at(3).action);
    EXPECT_EQ(joint.entity_a, 7u);
    EXPECT_EQ(joint.frame, std::nullopt);
    EXPECT_EQ(joint.joint.frame_b, hinge.frame_b);
    EXPECT_EQ(joint.joint.kind, hinge.kind);
    EXPECT_EQ(joint.joint.break_torque, 40);
    EXPECT_TRUE(joint.joint.collide_connected);
    const auto& deletion = std::get<DeleteJointCommand>(*commands.at(4).action);
    EXPECT_EQ(deletion.target, (physics::JointId{11, 2}));
    EXPECT_EQ(deletion.joint, 0u) << "ids of clients end with the process";
    for (std::size_t size = 0; size < bytes.size(); size++)
        EXPECT_FALSE(decode_journal(bytes.substr(0, size)).ok());
}

TEST(JournalCodec, players_attributes_and_messages_need_version_6) {
    const SetAttributesCommand attributes{{AttributeTargetKind::entity, 7},
                                          {{"a", true},
                                           {"b", std::int64_t{-5}},
                                           {"c", 0.25, AttributeVisibility::roles, 8},
                                           {"d", std::string("text"), AttributeVisibility::owner},
                                           {"e", physics::Vec3{1, 2, 3}},
                                           {"f", std::nullopt}}};
    const JournalSegment written{
        .ticks = {{4,
                   {{1, 0, JoinCommand{"ann", PlayerRole::builder, 0xff0000, 4}},
                    {1, 1, RenameCommand{"anna"}},
                    {0, 0, SetRoleCommand{1, PlayerRole::owner}},
                    {1, 2, attributes},
                    {1, 3, SendMessageCommand{"chat", "hello", {1, 2}}},
                    {1, 4, SendMessageCommand{"game", "ready", {}, true}}}}},
        .paused_ticks = {}};
    const std::string bytes = encode_journal(written);
    EXPECT_EQ(bytes[0], 6);
    const JournalSegment read_segment = decode_journal(bytes).value();
    const auto& commands = read_segment.ticks.at(0).commands;
    const auto& join = std::get<JoinCommand>(*commands.at(0).action);
    EXPECT_EQ(join.name + std::to_string(*join.color), "ann16711680");
    EXPECT_EQ(join.role, PlayerRole::builder);
    EXPECT_EQ(join.tick, 4u);
    EXPECT_EQ(std::get<RenameCommand>(*commands.at(1).action).name, "anna");
    EXPECT_EQ(std::get<SetRoleCommand>(*commands.at(2).action).role, PlayerRole::owner);
    const auto& read = std::get<SetAttributesCommand>(*commands.at(3).action);
    EXPECT_EQ(read.target, attributes.target);
    EXPECT_EQ(read.changes, attributes.changes);
    EXPECT_EQ(std::get<SendMessageCommand>(*commands.at(4).action).to,
              (std::vector<ClientId>{1, 2}));
    EXPECT_TRUE(std::get<SendMessageCommand>(*commands.at(5).action).to_server);
    const std::string old =
        encode_journal({.ticks = {{4, {{1, 1, ReleaseCommand{}}}}}, .paused_ticks = {}});
    EXPECT_EQ(old[0], 3) << "older servers read a journal without them";
}

TEST(JournalCodec, truncated_or_changed_bytes_are_rejected_or_read_within_bounds) {
    HostedWorld world = sandbox();
    const std::string whole = encode_journal(play(world, 12));
    for (std::size_t size = 0; size < whole.size(); size++)
        EXPECT_EQ(error_of(decode_journal(whole.substr(0, size))).code, ErrorCode::corrupt_data);
    EXPECT_EQ(error_of(decode_journal(whole + "x")).message,
              "corrupt journal record: data after the end");
    EXPECT_EQ(error_of(decode_journal("\x09")).message,
              "corrupt journal record: version 9; this server reads versions 2 to 8");
    test::Random random(5);
    int read = 0;
    for (int k = 0; k < 2000; k++) {
        std::string bytes = whole;
        for (int flips = 0; flips < 3; flips++)
            bytes[random.below(bytes.size())] = static_cast<char>(random.below(256));
        const auto journal = decode_journal(bytes);
        if (journal.ok())
            read++;
        else
            EXPECT_EQ(journal.error().code, ErrorCode::corrupt_data);
    }
    EXPECT_GT(read, 0) << "some flipped bits yield another valid number";
}

}  // namespace
}  // namespace jostle::server
