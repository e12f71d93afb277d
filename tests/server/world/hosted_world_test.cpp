// SPDX-License-Identifier: MIT
#include "server/world/hosted_world.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "jostle/scenes/catalog.h"
#include "tests/support/counter.h"
#include "tests/support/error_of.h"
#include "tests/support/step_time.h"

namespace jostle::server {

using test::error_of;

namespace {

using test::dt;

class HostedWorldTest : public testing::Test {
protected:
    InputResult apply(ClientId client, Action action) {
        return world.apply(
            {.client = client, .sequence = ++sequence, .action = std::move(action), .reply = {}},
            tick);
    }
    EntityId spawn(ClientId client, double y = 20) {
        SpawnCommand command;
        command.shape.geometry = physics::Sphere{0.3};
        command.pose.position = {5, y, 0};
        const InputResult result = apply(client, command);
        EXPECT_TRUE(result.status.ok()) << result.status.error().message;
        return result.entity;
    }
    Frame step(int times = 1) {
        for (int i = 0; i < times; ++i) EXPECT_TRUE(world.step(dt).ok());
        Frame frame;
        world.copy_into(frame);
        return frame;
    }
    static const EntityPose* find(const Frame& frame, EntityId id) {
        const auto at = std::ranges::find(frame.entities, id, &EntityPose::id);
        return at == frame.entities.end() ? nullptr : &*at;
    }

    HostedWorld world = std::move(*HostedWorld::create(
        *scenes::find_scene("stack"), {.scene = {.bodies_max = 20}, .bodies_owned_max = 3}, 1));
    std::uint32_t sequence = 0, tick = 7;
};

TEST_F(HostedWorldTest, frame_poses_match_the_entity_list) {
    const EntityId ball = spawn(1);
    const Frame frame = step();
    ASSERT_EQ(frame.entities.size(), frame.entity_list->size());
    for (std::size_t i = 0; i < frame.entities.size(); ++i) {
        EXPECT_EQ(frame.entities[i].id, (*frame.entity_list)[i]->id);
        EXPECT_TRUE(i == 0 || frame.entities[i - 1].id < frame.entities[i].id);
    }
    EXPECT_EQ(frame.entity_list->back()->id, ball);
    EXPECT_EQ(frame.entity_list->back()->owner, 1u);
    EXPECT_EQ(step().entity_list, frame.entity_list) << "nothing appeared or went: the same list";
    spawn(1);
    EXPECT_NE(step().entity_list, frame.entity_list);
}

TEST_F(HostedWorldTest, applies_each_input_at_most_once) {
    const Command command{.client = 1, .sequence = 5, .action = ReleaseCommand{}, .reply = {}};
    EXPECT_TRUE(world.apply(command, tick).status.ok());
    EXPECT_EQ(error_of(world.apply(command, tick).status).code, ErrorCode::invalid_argument);
}

TEST_F(HostedWorldTest, clients_delete_joints_by_the_ids_of_the_joint_list) {
    world.set_limits({.scene = {.bodies_max = 20}, .bodies_owned_max = 3, .joints_owned_max = 3});
    const EntityId ball = spawn(1);
    const auto join = [&] {
        return apply(1, CreateJointCommand{0, ball, physics::Transform{{5, 20, 0}, {}}, {}}).joint;
    };
    const std::uint32_t first = join(), second = join();
    EXPECT_NE(first, second);
    world.publish_joints(true);
    const Frame frame = step();
    ASSERT_EQ(frame.joint_list->size(), 2u);
    EXPECT_EQ(frame.joint_list->front()->id, first);
    const InputResult deleted = apply(1, DeleteJointCommand{.joint = first});
    EXPECT_TRUE(deleted.status.ok());
    EXPECT_EQ(deleted.joint, first);
    ASSERT_EQ(step().joint_list->size(), 1u);
    EXPECT_EQ(step().joint_list->front()->id, second);
    EXPECT_EQ(error_of(apply(1, DeleteJointCommand{.joint = first}).status).code,
              ErrorCode::not_found);
    EXPECT_EQ(error_of(apply(1, DeleteJointCommand{.joint = 999}).status).code,
              ErrorCode::not_found);
}

TEST_F(HostedWorldTest, never_reuses_entity_ids) {
    const EntityId first = spawn(1);
    EXPECT_TRUE(apply(1, DeleteCommand{first}).status.ok());
    const EntityId second = spawn(1);
    EXPECT_GT(second, first);
    EXPECT_EQ(error_of(apply(1, DeleteCommand{first}).status).code, ErrorCode::not_found);
    EXPECT_NE(find(step(), second), nullptr);
}

TEST_F(HostedWorldTest, enforces_limits_per_client_and_per_world) {
    for (int i = 0; i < 3; ++i) spawn(1, 20 + i);
    EXPECT_EQ(error_of(apply(1, SpawnCommand{}).status).code, ErrorCode::resource_exhausted);
    const std::size_t scene = step().entities.size() - 3;
    for (ClientId client = 2; step().entities.size() < 20; ++client) spawn(client, 20.0 + client);
    EXPECT_EQ(error_of(apply(99, SpawnCommand{}).status).code, ErrorCode::resource_exhausted);
    EXPECT_TRUE(apply(1, LeaveCommand{}).status.ok());
    EXPECT_EQ(step().entities.size(), 17u);
    EXPECT_GT(scene, 0u);
    EXPECT_TRUE(apply(99, SpawnCommand{}).status.ok());
}

TEST_F(HostedWorldTest, world_enforces_ownership) {
    const EntityId theirs = spawn(2);
    EXPECT_EQ(error_of(apply(1, DeleteCommand{theirs}).status).code, ErrorCode::permission_denied);
    EXPECT_EQ(error_of(apply(1, DeleteCommand{1}).status).code, ErrorCode::permission_denied)
        << "the scene's";
    EXPECT_EQ(
        error_of(apply(1, ImpulseCommand{.entity = 1, .impulse = {1, 0, 0}, .point = {}}).status)
            .code,
        ErrorCode::permission_denied)
        << "the ground is not dynamic";
    EXPECT_EQ(error_of(apply(1, DragCommand{}).status).code, ErrorCode::not_found)
        << "nothing is held";
}

TEST_F(HostedWorldTest, clamps_impulses_to_20_m_per_s) {
    const EntityId ball = spawn(1, 100);
    const double before = find(step(), ball)->pose.position.x;
    EXPECT_TRUE(
        apply(1, ImpulseCommand{.entity = ball, .impulse = {1e6, 0, 0}, .point = {}}).status.ok());
    EXPECT_NEAR(find(step(60), ball)->pose.position.x - before, 20, 1e-6);
}

TEST_F(HostedWorldTest, grabbed_body_follows_the_target_and_falls_on_release) {
    const EntityId ball = spawn(1, 10);
    const physics::Vec3 target{4, 12, 3};
    EXPECT_TRUE(apply(1, GrabCommand{ball, find(step(), ball)->pose.position}).status.ok());
    EXPECT_TRUE(apply(1, DragCommand{target}).status.ok());
    const Frame held = step(240);
    EXPECT_LT(length(find(held, ball)->pose.position - target), 0.2);
    EXPECT_TRUE(apply(1, ReleaseCommand{}).status.ok());
    EXPECT_LT(find(step(30), ball)->pose.position.y, target.y - 1);
}

TEST_F(HostedWorldTest, deleting_a_grabbed_body_releases_it) {
    const EntityId ball = spawn(2);
    EXPECT_TRUE(apply(1, GrabCommand{ball, {5, 20, 0}}).status.ok());
    EXPECT_TRUE(apply(2, DeleteCommand{ball}).status.ok());
    EXPECT_EQ(error_of(apply(1, DragCommand{}).status).code, ErrorCode::not_found);
    step(2);
}

TEST_F(HostedWorldTest, explosion_pushes_bodies_within_radius) {
    const EntityId near = spawn(1, 50);
    const double before = find(step(), near)->pose.position.x;
    const auto explode = [&](double x) {
        return apply(1, ExplodeCommand{.center = {x, 50, 0}, .radius = 4, .speed = 8}).status.ok();
    };
    EXPECT_TRUE(explode(-40));
    EXPECT_EQ(find(step(), near)->pose.position.x, before) << "far away";
    EXPECT_TRUE(explode(4));
    // A ball of half a metre and 520 kg: three quarters of 8 times 1000 N s/m^2 on its
    // front of pi / 4 m^2 are 9.0 m/s.
    EXPECT_NEAR(find(step(60), near)->pose.position.x - before, 9.4, 0.6);
}

TEST_F(HostedWorldTest, explosion_breaks_nearby_destructible_bodies) {
    world = HostedWorld::create(*scenes::find_scene("demolition"), {}, 1).value();
    const std::size_t whole = step(2).entities.size();
    const auto explode = [&](physics::Vec3 center) {
        return apply(1, ExplodeCommand{.center = center, .radius = 6, .speed = 12}).status.ok();
    };
    // Pieces come off 1.2 m round it: of the wall at x = 7, whose front is at z = -5.8.
    EXPECT_TRUE(explode({7, 2, -3}));
    EXPECT_EQ(step(2).entities.size(), whole) << "2.8 m in front of it";
    EXPECT_TRUE(explode({7, 2, -5.8}));
    EXPECT_GT(step(2).entities.size(), whole + 10);
}

TEST(HostedWorld, rejects_worlds_with_too_many_channel_kinds) {
    scenes::SceneDescription scene = *scenes::find_scene("stack");
    scene.modules.resize(65);
    const auto world = HostedWorld::create(scene, {}, 1);
    ASSERT_FALSE(world.ok());
    EXPECT_EQ(world.error().message,
              "the scene has 65 modules; a hosted world may have at most 64");
}

TEST(HostedWorld, frame_contains_module_channels_by_entity) {
    test::register_counter();
    scenes::SceneDescription scene = *scenes::find_scene("stack");
    scene.modules = {{.tag = "counter", .settings = {{"every", 2}}, .bodies = {{"watched", 3}}}};
    HostedWorld world = HostedWorld::create(scene, {}, 1).value();
    const auto frame_after = [&](int steps) {
        for (int i = 0; i < steps; i++) EXPECT_TRUE(world.step(dt).ok());
        Frame frame;
        world.copy_into(frame);
        return frame;
    };
    EXPECT_TRUE(frame_after(0).channels->empty()) << "modules speak after a step";
    const Frame two = frame_after(2), three = frame_after(1), four = frame_after(1);
    ASSERT_EQ(two.channels->size(), 1u);
    EXPECT_EQ(world.channel_kinds()[0].name, "counter");
    const Channel& told = two.channels->front();
    EXPECT_EQ(told.entity, two.entities[3].id);
    EXPECT_EQ(*told.values, std::vector<std::int32_t>{1});
    EXPECT_EQ(three.channels->front().values, told.values);
    EXPECT_NE(four.channels->front().values, told.values);
}

// Frames copy only what can have moved: against all bodies, while they fall, sleep and are pushed.
TEST_F(HostedWorldTest, every_frame_contains_the_current_pose_of_every_body) {
    std::vector<EntityId> balls;
    std::vector<physics::BodyState> bodies;
    int still = 0, asleep = 0;
    for (tick = 2; tick < 900; tick++) {
        if (tick % 150 == 3) balls.push_back(spawn(1 + tick / 150, 3));
        if (tick == 700) apply(1, DeleteCommand{balls.front()});
        if (tick == 600) apply(2, ExplodeCommand{.center = {0, 0.5, 0}, .radius = 6, .speed = 4});
        ASSERT_TRUE(world.step(dt, tick).ok());
        Frame frame;
        frame.tick = tick;
        world.copy_into(frame);
        still += frame.changed_at != tick;
        world.world().copy_bodies(bodies);
        ASSERT_EQ(frame.entities.size(), bodies.size());
        std::multiset<std::pair<double, double>> shown, there;
        for (const EntityPose& e : frame.entities) shown.emplace(e.pose.position.x, e.awake);
        for (const auto& body : bodies) {
            there.emplace(body.pose.position.x, body.awake);
            asleep += body.type == physics::BodyType::dynamic && !body.awake;
        }
        ASSERT_EQ(shown, there) << "tick " << tick;
    }
    EXPECT_GT(asleep, 500) << "some of them did sleep";
    EXPECT_GT(still, 100) << "and there were ticks in which nothing moved";
}

TEST_F(HostedWorldTest, repeated_impulses_are_limited_to_50_m_per_s) {
    const EntityId ball = spawn(1, 40);
    step();
    for (int i = 0; i < 100; i++) {
        const InputResult pushed = apply(
            1, ImpulseCommand{
                   .entity = ball, .impulse = {1e6, 0, 0}, .point = physics::Vec3{5, 40.3, 0}});
        ASSERT_TRUE(pushed.status.ok()) << pushed.status.error().message;
    }
    std::vector<physics::BodyState> bodies;
    world.world().copy_bodies(bodies);
    double fastest = 0, spin = 0;
    for (const physics::BodyState& body : bodies) {
        fastest = std::max(fastest, length(body.linear_velocity));
        spin = std::max(spin, length(body.angular_velocity));
    }
    EXPECT_NEAR(fastest, 50, 1e-9);
    EXPECT_LE(spin, 60 + 1e-9);
}

TEST(HostedWorld, rejects_spawns_in_crowded_locations) {
    HostedWorld world = std::move(*HostedWorld::create(*scenes::find_scene("stack"), {}, 1));
    int spawned = 0;
    InputResult last;
    for (std::uint32_t i = 1; i <= 60; i++) {
        SpawnCommand command;
        command.shape.geometry = physics::Sphere{0.3};
        command.pose.position = {5, 20, 0};
        // Two clients take turns, or what one may own would end it.
        last = world.apply({.client = 1 + i % 2, .sequence = i, .action = command, .reply = {}}, 7);
        spawned += last.status.ok() ? 1 : 0;
    }
    EXPECT_EQ(spawned, 41);
    EXPECT_EQ(last.status.error().message,
              "more than 40 shapes overlap the spawned body; spawn it elsewhere");
}

}  // namespace
}  // namespace jostle::server
