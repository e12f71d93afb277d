// SPDX-License-Identifier: MIT
//
// Joints of a hosted world to clients that request them.
#include "server/session/joints_section.h"

#include <gtest/gtest.h>

#include "jostle/scenes/catalog.h"
#include "tests/server/session/session_harness.h"
#include "tests/support/small_scene.h"

namespace jostle::server {
namespace {

using test::SessionHarness;
using test::TestServer;

// Four links that hang from the world by their ends.
scenes::SceneDescription chain_scene() {
    scenes::SceneDescription scene = test::small_scene();
    const std::size_t first = scene.bodies.size();
    for (std::size_t k = 0; k < 4; k++) {
        scenes::SceneBody link{.name = "link"};
        link.body.pose.position = {5 + static_cast<double>(k), 5, 0};
        link.shapes.push_back({.geometry = physics::Box{{0.4, 0.1, 0.1}}});
        scene.bodies.push_back(link);
        scene.joints.push_back(
            {.body_a = k == 0 ? scenes::world_body : first + k - 1,
             .body_b = first + k,
             .joint = {.frame_a = {.position = {k == 0 ? 4.5 : 0.5, k == 0 ? 5.0 : 0.0, 0}},
                       .frame_b = {.position = {-0.5, 0, 0}}}});
    }
    return scene;
}

TEST(JointsSection, only_clients_that_request_joints_receive_them) {
    TestServer server;
    const auto world = server.host(chain_scene());
    SessionHarness player(server, {.joints = true}), other(server, {});
    test::play(server, *world, {&player, &other}, 30);
    const auto& joints = player.conversation.view().joints();
    ASSERT_EQ(joints.size(), 4u);
    EXPECT_EQ(joints.begin()->second.entity_a, 0u);
    for (const auto& [id, joint] : joints)
        EXPECT_TRUE(player.conversation.view().entities().contains(joint.entity_b));
    EXPECT_TRUE(other.conversation.view().joints().empty());
    EXPECT_EQ(player.conversation.stats().decode_errors, 0u);
}

TEST(JointsSection, joints_of_a_client_that_joins_later_are_those_that_exist) {
    TestServer server;
    scenes::SceneDescription scene = chain_scene();
    scene.joints.back().joint.break_force = 1e-3;
    const auto world = server.host(scene);
    SessionHarness player(server, {.joints = true});
    test::play(server, *world, {&player}, 30);
    EXPECT_EQ(player.conversation.view().joints().size(), 3u) << "the last link broke";
    SessionHarness later(server, {.joints = true});
    test::play(server, *world, {&player, &later}, 30);
    EXPECT_EQ(later.conversation.view().joints().size(), 3u);
}

TEST(JointsSection, a_resumed_session_receives_the_complete_list) {
    TestServer server;
    const auto world = server.host(chain_scene());
    SessionHarness player(server, {.joints = true});
    test::play(server, *world, {&player}, 30);
    player.session.reset();
    player.drop_in_flight();
    player.connect();
    test::play(server, *world, {&player}, 30);
    EXPECT_EQ(player.conversation.view().joints().size(), 4u);
    EXPECT_EQ(player.conversation.stats().decode_errors, 0u);
}

// Two chains that are 600 m apart; the client sees 40 m.
TEST(JointsSection, a_client_with_an_area_of_interest_receives_the_joints_of_its_entities) {
    TestServer server;
    scenes::SceneDescription scene = chain_scene();
    const std::size_t first = scene.bodies.size() - 4;
    for (std::size_t k = 0; k < 4; k++) {
        scenes::SceneBody link = scene.bodies[first + k];
        link.body.pose.position.x += 600;
        scene.bodies.push_back(link);
    }
    for (std::size_t k = 1; k < 4; k++) {
        scenes::SceneJoint joint = scene.joints[k];
        joint.body_a += 4;
        joint.body_b += 4;
        scene.joints.push_back(joint);
    }
    const auto world = server.host(scene);
    client::ClientOptions options{.joints = true};
    options.interest = client::AreaOfInterest{.x = 5, .z = 0, .radius = 40};
    SessionHarness near(server, options), all(server, {.joints = true});
    test::play(server, *world, {&near, &all}, 60);
    EXPECT_EQ(all.conversation.view().joints().size(), 7u);
    const client::WorldView& view = near.conversation.view();
    ASSERT_EQ(view.joints().size(), 4u);
    for (const auto& [id, joint] : view.joints())
        EXPECT_TRUE(view.entities().contains(joint.entity_b));
    EXPECT_EQ(near.conversation.stats().decode_errors, 0u);
}

TEST(JointsSection, joints_of_an_area_of_interest_end_when_they_break) {
    TestServer server;
    scenes::SceneDescription scene = chain_scene();
    scene.joints.back().joint.break_force = 1e-3;
    const auto world = server.host(scene);
    client::ClientOptions options{.joints = true};
    options.interest = client::AreaOfInterest{.x = 5, .z = 0, .radius = 40};
    SessionHarness player(server, options);
    test::play(server, *world, {&player}, 60);
    EXPECT_EQ(player.conversation.view().joints().size(), 3u);
}

TEST(JointsSection, welcome_has_the_view_of_the_scene) {
    TestServer server;
    scenes::SceneDescription scene = test::small_scene();
    scene.world.planar = true;
    scene.view = scenes::SceneView{{1, 2, 3}, {4, 5, 6}, 0.8};
    for (std::size_t k = 1; k < scene.bodies.size(); k++) scene.bodies[k].body.pose.position.z = 0;
    const auto world = server.host(scene);
    std::vector<std::string> messages;
    SessionHarness player(
        server, {.on_message = [&](const std::string& bytes, auto) { messages.push_back(bytes); }});
    test::play(server, *world, {&player}, 2);
    v1::ServerMessage first;
    ASSERT_FALSE(messages.empty());
    ASSERT_TRUE(first.ParseFromString(messages.front()));
    EXPECT_TRUE(first.welcome().planar());
    EXPECT_EQ(first.welcome().view().target().y(), 5);
    EXPECT_EQ(first.welcome().view().field_of_view(), 0.8);
}

}  // namespace
}  // namespace jostle::server
