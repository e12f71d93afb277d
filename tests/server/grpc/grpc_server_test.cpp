// SPDX-License-Identifier: MIT
//
// C++ clients connected to a server in this process over the loopback device: channels of a module
// from the world thread to the views of the clients.
#include "server/grpc/grpc_server.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <thread>

#include "jostle/client/client.h"
#include "jostle/scenes/catalog.h"
#include "server/grpc/call_method.h"
#include "server/services/query_control.h"
#include "server/services/world_control.h"
#include "tests/server/server_parts.h"
#include "tests/support/counter.h"
#include "tests/support/wait_until.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using client::Client;
using test::wait_until;

// A value published by a test::Counter.
struct ChannelValue {
    std::uint32_t entity = 0, count = 0;
};

std::optional<ChannelValue> channel_value(const Client& client, std::string_view tag) {
    std::optional<ChannelValue> out;
    client.read([&](const client::WorldView& view) {
        for (const snapshot::Channel& channel : view.channels())
            if (view.channel_kinds()[channel.kind].name() == tag)
                out = {channel.entity, static_cast<std::uint32_t>(channel.values->front())};
    });
    return out;
}

std::string name_of(const Client& client, std::uint32_t entity) {
    std::string name;
    client.read([&](const client::WorldView& view) {
        if (const auto at = view.entities().find(entity); at != view.entities().end())
            name = at->second.name();
    });
    return name;
}

// A world whose module "counter" publishes a new value every fifth tick and whose module "still"
// never changes its value.
class GrpcServerTest : public testing::Test, protected ServerParts {
protected:
    GrpcServerTest() : ServerParts(4, 4, {.on_frame = [this](bool) { server.wake(); }}) {}
    void SetUp() override {
        test::register_counter();
        static const Status known = physics::register_module(
            "still", [] { return std::make_unique<test::Counter>("still"); });
        ASSERT_TRUE(known.ok());
        ASSERT_TRUE(server.start().ok());
    }
    void TearDown() override { stop_server(*this, server); }
    // The counter stops publishing at this count.
    void make_world(double until = 0) {
        scenes::SceneDescription scene = *scenes::find_scene("stack");
        scene.bodies[1].name = "observed";
        scene.modules = {
            {.tag = "counter",
             .settings = {{"every", 5}, {"until", until}},
             .bodies = {{"observed", 1}}},
            {.tag = "still", .settings = {{"every", 1e9}}, .bodies = {{"observed", 1}}}};
        const auto world = worlds.create("", scene);
        ASSERT_TRUE(world.ok()) << world.error().message;
    }
    std::shared_ptr<Client> join(std::vector<std::string> channels = {"*"}) {
        return Client::connect(loop, {.target = "127.0.0.1:" + std::to_string(server.port()),
                                      .channels = std::move(channels)});
    }

    std::vector<CallMethod> methods() {
        std::vector<CallMethod> all = world_methods(control, worlds, 4 << 20);
        std::ranges::move(query_methods(queries, worlds), std::back_inserter(all));
        return all;
    }

    WorldControl control{context};
    QueryControl queries{context};
    GrpcServer server{context, methods(), [] { return true; }, {.port = 0}};
    client::Loop loop;
};

TEST_F(GrpcServerTest, sends_channel_changes_and_current_values_to_late_joiners) {
    make_world();
    const auto early = join();
    ASSERT_TRUE(wait_until([&] { return channel_value(*early, "counter").has_value(); }));
    const ChannelValue first = *channel_value(*early, "counter");
    EXPECT_EQ(name_of(*early, first.entity), "observed");
    ASSERT_TRUE(
        wait_until([&] { return channel_value(*early, "counter")->count > first.count + 3; }));
    EXPECT_EQ(channel_value(*early, "still")->count, 0u);

    const std::uint32_t previous = channel_value(*early, "counter")->count;
    const auto late = join();
    ASSERT_TRUE(wait_until([&] { return channel_value(*late, "counter").has_value(); }));
    EXPECT_GE(channel_value(*late, "counter")->count, previous);
    ASSERT_TRUE(channel_value(*late, "still").has_value())
        << "published long before the client joined";
    EXPECT_EQ(channel_value(*late, "still")->entity, first.entity);
    EXPECT_EQ(early->stats().decode_errors + late->stats().decode_errors, 0u);
}

TEST_F(GrpcServerTest, removes_channels_that_are_no_longer_published) {
    make_world(30);  // 2.5 s
    const auto client = join();
    ASSERT_TRUE(wait_until([&] { return channel_value(*client, "counter").has_value(); }));
    ASSERT_TRUE(wait_until([&] { return !channel_value(*client, "counter").has_value(); }));
    client->read([](const client::WorldView& view) {
        ASSERT_EQ(view.channels().size(), 1u);
        EXPECT_EQ(view.channel_kinds()[view.channels()[0].kind].name(), "still");
    });
    EXPECT_EQ(client->stats().decode_errors, 0u);
}

TEST_F(GrpcServerTest, sends_only_requested_channel_kinds) {
    make_world();
    const auto all = join(), some = join({"still", "unheard of"}), none = join({});
    ASSERT_TRUE(wait_until([&] {
        return channel_value(*all, "counter").has_value() &&
               channel_value(*some, "still").has_value() && none->stats().snapshots > 5;
    }));
    EXPECT_FALSE(channel_value(*some, "counter").has_value());
    none->read([](const client::WorldView& view) {
        EXPECT_TRUE(view.channels().empty());
        EXPECT_EQ(view.channel_kinds().size(), 3u)
            << "the client must still know all channel kinds";
    });
}

}  // namespace
}  // namespace jostle::server
