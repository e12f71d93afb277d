// SPDX-License-Identifier: MIT
//
// C++ clients connected to a server in this process over the loopback device: channels of a module
// from the world thread to the views of the clients.
#include "server/grpc/grpc_server.h"

#include <fcntl.h>
#include <grpcpp/create_channel.h>
#include <grpcpp/create_channel_posix.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <iterator>
#include <thread>

#include "jostle/client/client.h"
#include "jostle/scenes/catalog.h"
#include "jostle/v1/world.grpc.pb.h"
#include "server/services/call_method.h"
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

// A server whose only method records the address of its caller.
class ProxiedGrpcTest : public testing::Test, protected ServerParts {
protected:
    ProxiedGrpcTest() : ServerParts(4, 4) {}

    CallMethod list_method() {
        return unary_method<v1::ListWorldsRequest, v1::ListWorldsResponse>(
            "/jostle.v1.WorldService/ListWorlds", CallWork::quick, 4096,
            [this](const CallContext& call, const auto&, auto&) -> Status {
                address = call.address;
                return {};
            });
    }
    // The address of the caller of ListWorlds with this metadata.
    std::string address_of(const std::shared_ptr<grpc::Channel>& channel,
                           const std::vector<std::pair<std::string, std::string>>& metadata) {
        address = "no call";
        grpc::ClientContext call;
        call.set_deadline(std::chrono::system_clock::now() + 5s);
        for (const auto& [name, value] : metadata) call.AddMetadata(name, value);
        v1::ListWorldsResponse response;
        const grpc::Status status =
            v1::WorldService::NewStub(channel)->ListWorlds(&call, {}, &response);
        return status.ok() ? address : status.error_message();
    }

    std::string address;
    const TrustedProxies proxies = TrustedProxies::create({"127.0.0.1"}, {}).value();
};

TEST_F(ProxiedGrpcTest, calls_have_the_address_that_a_trusted_proxy_names) {
    GrpcServer server{
        context, {list_method()}, [] { return true; }, {.port = 0, .proxies = &proxies}};
    ASSERT_TRUE(server.start().ok());
    const auto channel = grpc::CreateChannel("127.0.0.1:" + std::to_string(server.port()),
                                             grpc::InsecureChannelCredentials());
    EXPECT_EQ(address_of(channel, {}), "127.0.0.1");
    EXPECT_EQ(address_of(channel, {{"x-forwarded-for", "203.0.113.9"}}), "203.0.113.9");
    EXPECT_EQ(address_of(channel, {{"x-forwarded-for", "6.6.6.6"},
                                   {"x-forwarded-for", "203.0.113.9, 127.0.0.1"}}),
              "203.0.113.9")
        << "several lines";
    EXPECT_EQ(address_of(channel, {{"forwarded", "for=6.6.6.6"}}), "127.0.0.1");
    stop_server(*this, server);
}

TEST_F(ProxiedGrpcTest, connections_of_a_proxy_begin_with_a_proxy_header) {
    GrpcServer server{context,
                      {list_method()},
                      [] { return true; },
                      {.port = 0, .proxies = &proxies, .proxy_protocol = true}};
    ASSERT_TRUE(server.start().ok());
    const auto connect = [&](std::string_view first_bytes) {
        const int descriptor = ::socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in to{.sin_family = AF_INET, .sin_port = htons(server.port())};
        to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        EXPECT_EQ(::connect(descriptor, reinterpret_cast<const sockaddr*>(&to), sizeof to), 0);
        // In two pieces, between which the server waits.
        EXPECT_EQ(::send(descriptor, first_bytes.data(), 10, 0), 10);
        std::this_thread::sleep_for(20ms);
        EXPECT_GT(::send(descriptor, first_bytes.data() + 10, first_bytes.size() - 10, 0), 0);
        fcntl(descriptor, F_SETFL, O_NONBLOCK);
        return grpc::CreateInsecureChannelFromFd("proxy", descriptor);
    };
    // 203.0.113.9:4711 to 192.0.2.1:443.
    const std::string header(
        "\r\n\r\n\0\r\nQUIT\n\x21\x11\0\x0c\xcb\0\x71\x09\xc0\0\x02\x01\x12\x67\x01\xbb", 28);
    EXPECT_EQ(address_of(connect(header), {{"x-forwarded-for", "6.6.6.6"}}), "203.0.113.9");
    const std::string local("\r\n\r\n\0\r\nQUIT\n\x20\0\0\0", 16);
    EXPECT_EQ(address_of(connect(local), {}), "127.0.0.1") << "a connection of the proxy itself";
    EXPECT_NE(address_of(connect("PROXY TCP4 203.0.113.9 192.0.2.1 4711 443\r\n"), {}),
              "203.0.113.9")
        << "version 1 is refused";
    EXPECT_EQ(address, "no call");
    stop_server(*this, server);
}

}  // namespace
}  // namespace jostle::server
