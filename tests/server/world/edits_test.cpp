// SPDX-License-Identifier: MIT
//
// Edits, clones, joints and undos of clients in a world without a room.
#include <gtest/gtest.h>

#include <algorithm>

#include "jostle/physics/serialization.h"
#include "jostle/scenes/catalog.h"
#include "server/world/body_record.h"
#include "server/world/hosted_world.h"
#include "tests/support/error_of.h"
#include "tests/support/step_time.h"

namespace jostle::server {
namespace {

using namespace physics;
using test::dt;
using test::error_of;

constexpr ClientId actor = 1, other = 2;
constexpr EntityId floor_of_scene = 1, scene_box = 4;  // of the scene "stack"

HostedWorld new_world() {
    return std::move(*HostedWorld::create(
        *scenes::find_scene("stack"),
        {.scene = {.bodies_max = 100}, .bodies_owned_max = 40, .joints_owned_max = 8}, 1));
}

std::string state_of(const HostedWorld& world) {
    return std::to_string(state_hash(world.world())) + encode_host_state(world.host_state(9));
}

class EditsTest : public testing::Test {
protected:
    InputResult apply(ClientId client, Action action) {
        return world.apply(
            {.client = client, .sequence = ++sequence, .action = std::move(action), .reply = {}},
            1);
    }
    EntityId spawn(ClientId client, Vec3 at = {5, 20, 0}) {
        SpawnCommand command;
        command.shape.geometry = Box{{0.25, 0.25, 0.25}};
        command.pose.position = at;
        const InputResult result = apply(client, command);
        EXPECT_TRUE(result.status.ok()) << result.status.error().message;
        return result.entity;
    }
    JointId join(EntityId a, EntityId b, Vec3 at, JointKind kind = BallJoint{},
                 ClientId client = actor) {
        const InputResult result =
            apply(client, CreateJointCommand{a, b, Transform{at, {}}, {.kind = std::move(kind)}});
        EXPECT_TRUE(result.status.ok()) << result.status.error().message;
        return world.world().joints().back();
    }
    void undo(ClientId client = actor) {
        const Status undone = apply(client, UndoCommand{}).status;
        EXPECT_TRUE(undone.ok()) << undone.error().message;
    }
    void step(int times = 1) {
        for (int k = 0; k < times; k++) ASSERT_TRUE(world.step(dt).ok());
    }
    const EntityDescription* description(EntityId id) {
        world.copy_into(frame);
        const auto at = std::ranges::find(*frame.entity_list, id,
                                          [](const auto& entity) { return entity->id; });
        return at == frame.entity_list->end() ? nullptr : at->get();
    }
    BodyState body(EntityId id) {
        const auto entities = world.host_state(1).entities;
        return *world.world().body(
            std::ranges::find(entities, id, &SavedHostState::Entity::id)->body);
    }

    HostedWorld world = new_world();
    Frame frame;
    std::uint32_t sequence = 0;
};

TEST_F(EditsTest, edit_changes_what_it_names_and_undo_restores_it) {
    const EntityId box = spawn(actor);
    const double mass = body(box).mass;  // 0.5^3 * 1000
    EXPECT_NEAR(mass, 125, 1e-9);
    EXPECT_TRUE(apply(actor, EditCommand{.entity = box,
                                         .position = Vec3{7, 30, 1},
                                         .linear_velocity = Vec3{1, 2, 3},
                                         .mass = 40.0,
                                         .friction = 0.1,
                                         .color = 0x123456,
                                         .gravity_scale = 0.0})
                    .status.ok());
    EXPECT_EQ(body(box).pose.position, (Vec3{7, 30, 1}));
    EXPECT_NEAR(body(box).mass, 40, 1e-9);
    ASSERT_TRUE(description(box));
    EXPECT_EQ(description(box)->shapes[0].material.friction, 0.1);
    EXPECT_EQ(description(box)->shapes[0].material.restitution, 0);
    EXPECT_EQ(description(box)->color, 0x123456u);
    EXPECT_EQ(description(box)->owner, actor);
    step(60);
    EXPECT_NEAR(body(box).pose.position.y, 32, 1e-6) << "no gravity, 2 m/s for 1 s";
    undo();
    EXPECT_EQ(body(box).pose.position, (Vec3{5, 20, 0}));
    EXPECT_NEAR(body(box).mass, mass, 1e-9);
    EXPECT_EQ(description(box)->shapes[0].material.friction, 0.5);
    EXPECT_EQ(description(box)->color, std::nullopt);
    EXPECT_EQ(description(box)->gravity_scale, 1);
}

TEST_F(EditsTest, density_replaces_an_explicit_mass) {
    const EntityId box = spawn(actor);
    EXPECT_TRUE(apply(actor, EditCommand{.entity = box, .mass = 40.0}).status.ok());
    EXPECT_TRUE(apply(actor, EditCommand{.entity = box, .density = 2000.0}).status.ok());
    EXPECT_NEAR(body(box).mass, 250, 1e-9);
    undo();
    EXPECT_NEAR(body(box).mass, 40, 1e-9);
    undo();
    EXPECT_NEAR(body(box).mass, 125, 1e-9);
}

TEST_F(EditsTest, frozen_body_stays_until_it_is_unfrozen) {
    const EntityId box = spawn(actor);
    step(10);
    const Vec3 velocity = body(box).linear_velocity;
    EXPECT_LT(velocity.y, -1);
    EXPECT_TRUE(apply(actor, GrabCommand{box, body(box).pose.position}).status.ok());
    EXPECT_TRUE(apply(actor, EditCommand{.entity = box, .frozen = true}).status.ok());
    const Vec3 at = body(box).pose.position;
    step(30);
    EXPECT_EQ(body(box).pose.position, at);
    EXPECT_EQ(description(box)->type, BodyType::static_body);
    const Error refused = error_of(apply(actor, EditCommand{.entity = box, .mass = 3.0}).status);
    EXPECT_EQ(refused.code, ErrorCode::permission_denied);
    undo();
    EXPECT_EQ(description(box)->type, BodyType::dynamic);
    EXPECT_EQ(body(box).linear_velocity, velocity);
    EXPECT_TRUE(apply(actor, EditCommand{.entity = box, .frozen = true}).status.ok());
    EXPECT_TRUE(apply(actor, EditCommand{.entity = box, .frozen = false}).status.ok());
    EXPECT_TRUE(body(box).awake);
}

TEST_F(EditsTest, edit_of_other_and_static_bodies_is_refused) {
    const EntityId box = spawn(other);
    for (const EntityId id : {box, scene_box, floor_of_scene})
        EXPECT_EQ(error_of(apply(actor, EditCommand{.entity = id, .mass = 3.0}).status).code,
                  ErrorCode::permission_denied);
    EXPECT_EQ(error_of(apply(actor, EditCommand{.entity = 999, .mass = 3.0}).status).code,
              ErrorCode::not_found);
    EXPECT_EQ(error_of(apply(other, EditCommand{.entity = box}).status).code,
              ErrorCode::invalid_argument);
    EXPECT_EQ(error_of(apply(actor, UndoCommand{}).status).code, ErrorCode::not_found);
}

TEST_F(EditsTest, failed_edit_changes_nothing) {
    const EntityId box = spawn(actor);
    join(0, box, {5, 20, 0});
    const std::string before = state_of(world);
    const InputResult result =
        apply(actor, EditCommand{.entity = box, .position = Vec3{9, 9, 9}, .frozen = true});
    EXPECT_EQ(error_of(result.status).code, ErrorCode::permission_denied)
        << "a joint needs a dynamic body";
    EXPECT_EQ(body(box).pose.position, (Vec3{5, 20, 0}));
    EXPECT_EQ(description(box)->type, BodyType::dynamic);
}

TEST_F(EditsTest, clone_copies_a_group_with_its_joints) {
    const EntityId a = spawn(actor, {5, 20, 0}), b = spawn(actor, {6, 20, 0}),
                   c = spawn(actor, {7, 20, 0});
    join(a, b, {5.5, 20, 0});
    join(b, c, {6.5, 20, 0}, HingeJoint{});
    join(0, a, {5, 20, 0});
    const std::size_t joints = world.world().joints().size(), bodies = world.entities();
    const InputResult result =
        apply(actor, CloneCommand{.entity = b, .offset = {0, 10, 0}, .jointed = true});
    ASSERT_TRUE(result.status.ok()) << result.status.error().message;
    EXPECT_EQ(world.entities(), bodies + 3);
    EXPECT_EQ(world.world().joints().size(), joints + 2) << "not the joint to the world";
    EXPECT_EQ(body(result.entity).pose.position, (Vec3{6, 30, 0}));
    undo();
    EXPECT_EQ(world.entities(), bodies);
    EXPECT_EQ(world.world().joints().size(), joints);
    const InputResult single = apply(actor, CloneCommand{.entity = b, .offset = {0, 3, 0}});
    EXPECT_TRUE(single.status.ok());
    EXPECT_EQ(world.entities(), bodies + 1);
    EXPECT_EQ(world.ownership().count(actor), 4);
}

TEST_F(EditsTest, joints_hold_break_and_are_limited) {
    const EntityId box = spawn(actor);
    join(0, box, {5, 20, 0});
    step(60);
    EXPECT_NEAR(body(box).pose.position.y, 20, 1e-3);
    const JointDef weak{.kind = BallJoint{}, .break_force = 10};
    const EntityId heavy = spawn(actor, {8, 20, 0});
    EXPECT_TRUE(
        apply(actor, CreateJointCommand{0, heavy, Transform{{8, 20, 0}, {}}, weak}).status.ok());
    step(30);
    EXPECT_LT(body(heavy).pose.position.y, 19.5) << "125 kg break a joint of 10 N";
    for (int k = 0; k < 7; k++) join(0, box, {5, 20, 0});
    const Error refused =
        error_of(apply(actor, CreateJointCommand{0, box, Transform{{5, 20, 0}, {}}, {}}).status);
    EXPECT_EQ(refused.code, ErrorCode::resource_exhausted);
    EXPECT_EQ(refused.message,
              "the client owns 8 joints; client.joints_owned_max allows 8; delete a joint first");
    EXPECT_EQ(error_of(apply(actor, CreateJointCommand{box, box, {}, {}}).status).code,
              ErrorCode::invalid_argument);
    EXPECT_EQ(error_of(apply(other, CreateJointCommand{0, floor_of_scene, {}, {}}).status).code,
              ErrorCode::permission_denied)
        << "one of the two is dynamic";
    EXPECT_EQ(error_of(apply(actor, CreateJointCommand{0, 999, {}, {}}).status).code,
              ErrorCode::not_found);
}

TEST_F(EditsTest, joint_is_deleted_by_its_owner_and_returns_by_undo) {
    const EntityId box = spawn(actor);
    const JointId joint = join(0, box, {5, 20, 0}, DistanceJoint{.min_length = 0, .max_length = 1});
    EXPECT_EQ(error_of(apply(other, DeleteJointCommand{.target = joint}).status).code,
              ErrorCode::permission_denied);
    EXPECT_TRUE(apply(actor, DeleteJointCommand{.target = joint}).status.ok());
    EXPECT_TRUE(world.world().joints_of(body(box).id).empty());
    undo();
    ASSERT_EQ(world.world().joints_of(body(box).id).size(), 1u);
    const JointDef def = world.world().joint(world.world().joints_of(body(box).id)[0])->def;
    EXPECT_EQ(std::get<DistanceJoint>(def.kind).max_length, 1);
    undo();  // the joint was created
    EXPECT_TRUE(world.world().joints_of(body(box).id).empty());
    EXPECT_EQ(error_of(apply(actor, DeleteJointCommand{.target = joint}).status).code,
              ErrorCode::not_found);
}

TEST_F(EditsTest, deleted_body_returns_with_its_joints) {
    const EntityId a = spawn(actor, {5, 20, 0}), b = spawn(actor, {6, 20, 0});
    EXPECT_TRUE(
        apply(actor, EditCommand{.entity = a, .restitution = 0.7, .color = 0xff}).status.ok());
    join(a, b, {5.5, 20, 0});
    step(5);
    const Transform pose = body(a).pose;
    EXPECT_TRUE(apply(actor, DeleteCommand{a}).status.ok());
    step(5);
    const InputResult undone = apply(actor, UndoCommand{});
    ASSERT_TRUE(undone.status.ok()) << undone.status.error().message;
    EXPECT_NE(undone.entity, a) << "ids are never reused";
    EXPECT_EQ(body(undone.entity).pose.position, pose.position);
    EXPECT_EQ(description(undone.entity)->shapes[0].material.restitution, 0.7);
    EXPECT_EQ(description(undone.entity)->color, 0xffu);
    EXPECT_EQ(world.world().joints_of(body(undone.entity).id).size(), 1u);
    EXPECT_EQ(world.ownership().count(actor), 2);
    apply(actor, UndoCommand{});  // the joint ended with the body
    undo();                       // the edit, under the new id
    EXPECT_EQ(description(undone.entity)->shapes[0].material.restitution, 0);
}

TEST_F(EditsTest, undo_reverts_the_actions_of_its_client_only) {
    const EntityId mine = spawn(actor, {5, 20, 0});
    const EntityId theirs = spawn(other, {8, 20, 0});
    undo();
    EXPECT_EQ(description(mine), nullptr);
    EXPECT_NE(description(theirs), nullptr);
    EXPECT_EQ(error_of(apply(actor, UndoCommand{}).status).code, ErrorCode::not_found);
    for (int k = 0; k < 40; k++)
        EXPECT_TRUE(apply(other, EditCommand{.entity = theirs, .mass = 1.0 + k}).status.ok());
    int undone = 0;
    while (apply(other, UndoCommand{}).status.ok()) undone++;
    EXPECT_EQ(undone, 32);
    EXPECT_NEAR(body(theirs).mass, 8, 1e-9);
    apply(other, LeaveCommand{});
    EXPECT_TRUE(world.host_state(1).undo.empty());
}

// jostlectl and AdminService.ApplyInput.
TEST_F(EditsTest, server_builds_without_an_owner_and_undoes_for_a_client) {
    world.enable_journal();
    const auto as_server = [&](Action action, ClientId client = scene_client) {
        InputResult result;
        const Status done = world.apply_between_inputs(client, action, result);
        EXPECT_TRUE(done.ok()) << done.error().message;
        return result;
    };
    SpawnCommand box;
    box.shape.geometry = Box{{0.25, 0.25, 0.25}};
    box.pose.position = {5, 20, 0};
    const EntityId first = as_server(box).entity;
    for (int k = 1; k <= 45; k++)  // a client may own 40
        as_server(CloneCommand{first, {2.0 * k, 0, 0}});
    as_server(EditCommand{.entity = first, .mass = 7});
    EXPECT_EQ(body(first).mass, 7);
    EXPECT_EQ(description(first)->owner, scene_client);
    const std::uint32_t joint =
        as_server(CreateJointCommand{0, first, Transform{{5, 20, 0}, {}}, {.kind = BallJoint{}}})
            .joint;
    ASSERT_NE(joint, 0u);
    as_server(DeleteJointCommand{.joint = joint});
    EXPECT_TRUE(world.world().joints().empty());
    EXPECT_TRUE(world.host_state(1).undo.empty());
    EXPECT_TRUE(world.host_state(1).owned.empty());

    const EntityId own = spawn(actor, {5, 30, 0});
    EXPECT_EQ(as_server(UndoCommand{}, actor).entity, own);
    EXPECT_EQ(description(own), nullptr);
    HostedWorld replayed = new_world();
    for (const JournaledCommand& one : world.take_journal()) replayed.replay(one);
    step();
    ASSERT_TRUE(replayed.step(dt).ok());
    EXPECT_EQ(state_of(replayed), state_of(world));
}

// A session of all kinds of actions.
class EditsReplayTest : public EditsTest {
protected:
    void act(int tick) {
        const ClientId client = tick % 3 == 0 ? other : actor;
        const EntityId id = static_cast<EntityId>(1 + tick * 7 % 60);
        const EntityId next = static_cast<EntityId>(1 + tick * 5 % 50);
        switch (tick % 11) {
            case 0:
            case 1:
            case 2: {
                SpawnCommand command;
                command.shape.geometry = Box{{0.25, 0.25, 0.25}};
                command.pose.position = {4.0 + tick % 5, 3.0 + tick % 7, 0};
                apply(client, command);
                break;
            }
            case 3:
                apply(client, EditCommand{.entity = id, .mass = 3.0 + tick, .friction = 0.2});
                break;
            case 4:
                apply(client, CreateJointCommand{id,
                                                 next,
                                                 Transform{{5, 5, 0}, {}},
                                                 {.kind = HingeJoint{}, .break_force = 1e4}});
                break;
            case 5:
                apply(client, CloneCommand{id, {0, 2, 0}, true});
                break;
            case 6:
                apply(client, EditCommand{.entity = id, .frozen = tick % 2 == 0});
                break;
            case 7:
                apply(client, DeleteCommand{id});
                break;
            case 8:
                if (!world.world().joints().empty())
                    apply(client, DeleteJointCommand{.target = world.world().joints().front()});
                break;
            default:
                apply(client, UndoCommand{});
        }
    }
};

TEST_F(EditsReplayTest, replay_and_restored_copies_have_equal_bits) {
    world.enable_journal();
    HostedWorld replayed = new_world();
    for (int tick = 0; tick < 300; tick++) {
        act(tick);
        for (const JournaledCommand& one : world.take_journal()) replayed.replay(one);
        if (tick % 40 == 20) {
            const SavedHostState saved =
                *decode_host_state(encode_host_state(replayed.host_state(1)));
            replayed = std::move(*HostedWorld::restore(
                std::move(*load(save(replayed.world()))), saved,
                {.scene = {.bodies_max = 100}, .bodies_owned_max = 40, .joints_owned_max = 8}, 60,
                0));
        }
        step();
        ASSERT_TRUE(replayed.step(dt).ok());
        ASSERT_EQ(state_of(replayed), state_of(world)) << "tick " << tick;
        ASSERT_EQ(replayed.data_hash(), world.data_hash());
    }
    EXPECT_TRUE(world.host_state(1).has_edits());
    EXPECT_GT(world.host_state(1).undo.size(), 0u);
}

TEST(SavedHostStateWithEdits, corrupt_edits_are_refused) {
    SavedHostState state;
    state.revisions = 3;
    state.updated_entities = {{1, 4, 0}};
    EXPECT_EQ(error_of(decode_host_state(encode_host_state(state))).message,
              "corrupt host state: updated entity 1 has revision 4 of 3");
    state.updated_entities.clear();
    state.undo = {{5, {}}};
    EXPECT_EQ(error_of(decode_host_state(encode_host_state(state))).code, ErrorCode::corrupt_data);
    state.undo = {{5, std::vector<UndoStep>(33)}};
    EXPECT_EQ(error_of(decode_host_state(encode_host_state(state))).code, ErrorCode::corrupt_data);
    const std::string bytes = [&] {
        state.undo = {{5, std::vector<UndoStep>(3)}};
        return encode_host_state(state);
    }();
    for (std::size_t size = 1; size < bytes.size(); size++)
        EXPECT_FALSE(decode_host_state(bytes.substr(0, size)).ok());
}

TEST(BodyRecord, is_small_and_survives_a_round_trip) {
    World world;
    const BodyId body = *world.create_body(
        {.pose = {{1, 2, 3}, {}}, .linear_velocity = {4, 5, 6}, .gravity_scale = 0.5},
        {.geometry = Capsule{0.3, 0.4}, .material = {.friction = 0.9}});
    const std::string record = record_body(world, body);
    EXPECT_LT(record.size(), 2048u);
    const BodyAndShapes def = *body_of_record(record);
    EXPECT_EQ(def.body.linear_velocity, (Vec3{4, 5, 6}));
    EXPECT_EQ(def.shapes.at(0).material.friction, 0.9);
    EXPECT_FALSE(body_of_record("junk").ok());
    EXPECT_FALSE(joint_of_record(record).ok());
    const JointDef joint{.kind = SliderJoint{.friction_force = 7}, .break_torque = 5};
    EXPECT_EQ(joint_of_record(record_joint(joint))->break_torque, 5);
}

}  // namespace
}  // namespace jostle::server
