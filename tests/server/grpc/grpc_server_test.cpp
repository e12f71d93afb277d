// SPDX-License-Identifier: MIT
//
// C++ clients at a server in this process, over the loopback device: what a module tells, from the
// world's thread to the clients' views.
#include "server/grpc/grpc_server.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <thread>

#include "jostle/client/client.h"
#include "jostle/scenes/catalog.h"
#include "server/grpc/query_methods.h"
#include "server/grpc/world_methods.h"
#include "server/services/query_control.h"
#include "server/services/world_control.h"
#include "tests/support/counter.h"
#include "tests/support/wait_until.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using client::Client;
using test::wait_until;

// What a test::Counter told.
struct Told {
    std::uint32_t entity = 0, count = 0;
};

std::optional<Told> told(const Client& client, std::string_view tag) {
    std::optional<Told> out;
    client.read([&](const client::WorldView& view) {
        for (const wire::Channel& channel : view.channels())
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

// A world whose "counter" tells something else every fifth tick and whose "still" never does.
class GrpcServerTest : public testing::Test {
protected:
    void SetUp() override {
        test::register_counter();
        static const Status known = physics::register_module(
            "still", [] { return std::make_unique<test::Counter>("still"); });
        ASSERT_TRUE(known.ok());
        ASSERT_TRUE(server.start().ok());
    }
    void TearDown() override {
        worlds.stop_all();  // before whom they wake
        context.closing = true;
        server.drain({});
        server.wake();
        server.stop();
    }
    // The counter falls silent at that count.
    void make_world(double until = 0) {
        scenes::SceneDescription scene = *scenes::find_scene("stack");
        scene.bodies[1].name = "watched";
        scene.modules = {
            {.tag = "counter",
             .settings = {{"every", 5}, {"until", until}},
             .bodies = {{"watched", 1}}},
            {.tag = "still", .settings = {{"every", 1e9}}, .bodies = {{"watched", 1}}}};
        const auto world = worlds.create("", scene);
        ASSERT_TRUE(world.ok()) << world.error().message;
    }
    std::shared_ptr<Client> join(std::vector<std::string> channels = {"*"}) {
        return Client::connect(loop, {.target = "127.0.0.1:" + std::to_string(server.port()),
                                      .channels = std::move(channels)});
    }

    std::vector<CallMethod> methods() {
        std::vector<CallMethod> all = world_methods(control, worlds);
        std::ranges::move(query_methods(queries, worlds), std::back_inserter(all));
        return all;
    }

    Config config;
    SessionDirectory sessions{4};
    GrpcServer* woken = &server;
    WorldDirectory worlds{{.on_frame = [this](bool) { woken->wake(); }}, 4};
    const std::unique_ptr<Authorizer> authorizer = *Authorizer::open(config);
    PlayContext context{
        .config = config, .worlds = worlds, .sessions = sessions, .authorizer = *gate};
    WorldControl control{context};
    QueryControl queries{context};
    GrpcServer server{context, methods(), [] { return true; }, {.port = 0}};
    client::Loop loop;
};

TEST_F(GrpcServerTest, sends_channel_changes_and_current_values_to_late_joiners) {
    make_world();
    const auto early = join();
    ASSERT_TRUE(wait_until([&] { return told(*early, "counter").has_value(); }));
    const Told first = *told(*early, "counter");
    EXPECT_EQ(name_of(*early, first.entity), "watched");
    ASSERT_TRUE(wait_until([&] { return told(*early, "counter")->count > first.count + 3; }));
    EXPECT_EQ(told(*early, "still")->count, 0u);

    const std::uint32_t before = told(*early, "counter")->count;
    const auto late = join();
    ASSERT_TRUE(wait_until([&] { return told(*late, "counter").has_value(); }));
    EXPECT_GE(told(*late, "counter")->count, before);
    ASSERT_TRUE(told(*late, "still").has_value()) << "told long before it came";
    EXPECT_EQ(told(*late, "still")->entity, first.entity);
    EXPECT_EQ(early->stats().decode_errors + late->stats().decode_errors, 0u);
}

TEST_F(GrpcServerTest, removes_channels_that_are_no_longer_published) {
    make_world(30);  // after two and a half seconds
    const auto client = join();
    ASSERT_TRUE(wait_until([&] { return told(*client, "counter").has_value(); }));
    ASSERT_TRUE(wait_until([&] { return !told(*client, "counter").has_value(); }));
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
        return told(*all, "counter").has_value() && told(*some, "still").has_value() &&
               none->stats().snapshots > 5;
    }));
    EXPECT_FALSE(told(*some, "counter").has_value());
    none->read([](const client::WorldView& view) {
        EXPECT_TRUE(view.channels().empty());
        EXPECT_EQ(view.channel_kinds().size(), 3u) << "but knows what there is";
    });
}

}  // namespace
}  // namespace jostle::server
