// SPDX-License-Identifier: MIT
//
// Queries and events end to end: the real server over gRPC, WebSocket and HTTP.
#include <grpcpp/create_channel.h>
#include <grpcpp/generic/generic_stub.h>
#include <grpcpp/support/byte_buffer.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <cmath>
#include <thread>

#include "grpc/health/v1/health.grpc.pb.h"
#include "jostle/client/client.h"
#include "jostle/client/query_client.h"
#include "jostle/v1/query.grpc.pb.h"
#include "tests/system/player.h"
#include "tests/system/server_process.h"

namespace jostle::test {
namespace {

using namespace std::chrono_literals;
namespace asio = boost::asio;

class QueryAndEvents : public testing::Test {
protected:
    void SetUp() override { ASSERT_TRUE(server.is_running()) << server.log(); }
    void TearDown() override {
        server.signal(SIGTERM);
        EXPECT_EQ(server.wait(10s), 0) << server.log();
    }
    // Far from the stack, above the ground.
    static constexpr double x = 8, height = 3;

    ServerProcess server{{"--scene", "stack", "--listen", "127.0.0.1:0", "--http", "127.0.0.1:0"}};
};

// A ball falls, lands and is deleted. A client that subscribes to events must receive all of these
// events.
void drop_and_delete(Player& player, double x, double height) {
    player.hello({}, "listener", true);
    ASSERT_TRUE(player.wait_until([](const PlayState& s) { return s.snapshots > 0; }));
    player.send_inputs({spawn_ball(x, height + 0.5, 0)});
    ASSERT_TRUE(player.wait_until([](const PlayState& s) { return s.results.size() == 1; }));
    const std::uint32_t ball = player.with_state([](const PlayState& s) {
        EXPECT_EQ(s.results.at(1).code(), v1::INPUT_CODE_APPLIED) << s.results.at(1).message();
        return s.results.at(1).entity();
    });
    const auto of_ball = [ball](const auto& list) {
        std::vector<v1::ContactEvent> found;
        for (const v1::ContactEvent& c : list)
            if (c.entity_a() == ball || c.entity_b() == ball) found.push_back(c);
        return found;
    };
    // Only batches acknowledge snapshots; without them the window would close.
    const auto wait_for = [&](const std::function<bool(const v1::Events&)>& is_expected) {
        for (int i = 0; i < 300; i++) {
            player.send_inputs({});
            if (player.wait_until(
                    [&](const PlayState& s) { return std::ranges::any_of(s.events, is_expected); },
                    34ms))
                return true;
        }
        return false;
    };
    ASSERT_TRUE(
        wait_for([&](const v1::Events& e) { return !of_ball(e.contacts_began()).empty(); }));
    player.send_inputs({remove_body(ball)});
    ASSERT_TRUE(
        wait_for([&](const v1::Events& e) { return !of_ball(e.contacts_ended()).empty(); }));
    player.with_state([&](const PlayState& s) {
        std::vector<v1::ContactEvent> began, hits, ended;
        for (const v1::Events& tick : s.events) {
            EXPECT_EQ(tick.missed(), 0u);
            for (const auto& c : of_ball(tick.contacts_began())) began.push_back(c);
            for (const auto& c : of_ball(tick.hits())) hits.push_back(c);
            for (const auto& c : of_ball(tick.contacts_ended())) ended.push_back(c);
        }
        const double speed = std::sqrt(2 * 9.81 * height);
        ASSERT_EQ(began.size(), 1u);
        EXPECT_NEAR(began[0].speed(), speed, 0.03 * speed) << "one tick of free fall adds 0.16 m/s";
        EXPECT_NEAR(began[0].point().x(), x, 0.01);
        EXPECT_EQ(hits.size(), 1u);
        EXPECT_EQ(ended.size(), 1u) << "the contact must end although the ball was deleted";
        EXPECT_EQ(s.violations, 0) << s.first_violation;
    });
}

TEST_F(QueryAndEvents, grpc_client_receives_events) {
    drop_and_delete(*grpc_player(server.grpc_address()), x, height);
}

TEST_F(QueryAndEvents, websocket_client_receives_events) {
    drop_and_delete(*websocket_player(server.http_port()), x, height);
}

TEST_F(QueryAndEvents, client_library_queries_and_receives_events) {
    client::Loop loop;
    const auto me =
        client::Client::connect(loop, {.target = server.grpc_address(), .events = true});
    v1::Input drop = spawn_ball(x, height + 0.5, 0);
    me->send(drop);
    const auto soon = [](const std::function<bool()>& condition) {
        for (const auto end = std::chrono::steady_clock::now() + 10s;
             std::chrono::steady_clock::now() < end; std::this_thread::sleep_for(5ms))
            if (condition()) return true;
        return false;
    };
    std::uint32_t ball = 0;
    ASSERT_TRUE(soon([&] {
        for (const v1::InputResult& result : me->take_results()) ball = result.entity();
        return ball != 0;
    }));
    bool landed = false;
    EXPECT_TRUE(soon([&] {
        for (const v1::Events& tick : me->take_events())
            for (const v1::ContactEvent& c : tick.contacts_began())
                landed |= c.entity_a() == ball || c.entity_b() == ball;
        return landed;
    }));

    client::QueryClient queries(server.grpc_address(), "stack");
    const auto hit = queries.cast_ray({x, 10, 0}, {0, -20, 0});
    ASSERT_TRUE(hit.ok()) << hit.error().message;
    ASSERT_TRUE(hit->value);
    EXPECT_EQ(hit->value->entity, ball);
    EXPECT_NEAR(hit->value->fraction, 9.0 / 20, 1e-3);
    EXPECT_NEAR(hit->value->normal[1], 1, 1e-6);
    EXPECT_GT(hit->tick, 0u);
    const auto ground = queries.cast_ray({x, 10, 0}, {0, -20, 0}, {.ignore = ball});
    ASSERT_TRUE(ground.ok() && ground->value);
    EXPECT_NE(ground->value->entity, ball);
    EXPECT_FALSE(queries.cast_ray({x, 10, 0}, {0, 20, 0})->value) << "there is nothing above";
    EXPECT_EQ(queries.overlap({x, 0.5, 0})->value.entities, std::vector{ball});
    v1::Shape probe;
    probe.mutable_sphere()->set_radius(0.1);
    probe.mutable_position()->set_x(x);
    probe.mutable_position()->set_y(0.5);
    EXPECT_EQ(queries.overlap(probe)->value.entities, std::vector{ball});
    const auto nearest = queries.closest_point({x, 2, 0}, 5);
    ASSERT_TRUE(nearest.ok() && nearest->value);
    EXPECT_EQ(nearest->value->entity, ball);
    EXPECT_NEAR(nearest->value->distance, 1, 1e-2);
    const auto inspected = queries.inspect_entity(ball);
    ASSERT_TRUE(inspected.ok()) << inspected.error().message;
    EXPECT_EQ(inspected->value.entity(), ball);
    EXPECT_NEAR(inspected->value.position().y(), 0.5, 0.6);
    EXPECT_EQ(queries.inspect_joint(99).error().message, "joint 99 does not exist");
    EXPECT_EQ(
        client::QueryClient(server.grpc_address(), "nowhere").overlap({0, 0, 0}).error().message,
        "there is no world \"nowhere\"");
    me->leave();
    EXPECT_TRUE(soon([&] { return !me->stats().connected; }));
}

TEST_F(QueryAndEvents, a_query_beyond_the_share_of_its_player_is_refused_with_a_time_to_retry) {
    // A full balance of 0.1 ms of processor time.
    ServerProcess small{{"--scene", "stack", "--listen", "127.0.0.1:0", "--http", "127.0.0.1:0",
                         "--set", "quota.query_share=0.0001"}};
    ASSERT_TRUE(small.is_running()) << small.log();
    client::QueryClient queries(small.grpc_address(), "stack");
    auto hit = queries.cast_ray({x, 10, 0}, {0, -20, 0});
    ASSERT_TRUE(hit.ok()) << hit.error().message;
    for (int i = 0; i < 20 && hit.ok(); i++) hit = queries.cast_ray({x, 10, 0}, {0, -20, 0});
    ASSERT_FALSE(hit.ok());
    EXPECT_EQ(hit.error().code, ErrorCode::resource_exhausted);
    EXPECT_GE(hit.error().retry_after_ms, 100);
    EXPECT_NE(hit.error().message.find("retry after "), std::string::npos) << hit.error().message;
    small.signal(SIGTERM);
    EXPECT_EQ(small.wait(10s), 0) << small.log();
}

TEST_F(QueryAndEvents, http_serves_json_queries_and_health_lists_the_service) {
    const std::string body = R"({"rays": [{"origin": {"y": 50}, "motion": {"y": -100}}]})";
    asio::io_context io;
    asio::ip::tcp::socket socket(io);
    socket.connect(
        {asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(server.http_port())});
    asio::write(socket,
                asio::buffer("POST /api/query/CastRays HTTP/1.1\r\nHost: localhost\r\nConnection: "
                             "close\r\nContent-Type: application/json\r\nContent-Length: " +
                             std::to_string(body.size()) + "\r\n\r\n" + body));
    std::string answer;
    boost::system::error_code end;
    asio::read(socket, asio::dynamic_buffer(answer), end);
    EXPECT_TRUE(answer.starts_with("HTTP/1.1 200")) << answer;
    EXPECT_NE(answer.find("\"entity\":"), std::string::npos) << answer;

    const auto channel =
        grpc::CreateChannel(server.grpc_address(), grpc::InsecureChannelCredentials());
    grpc::ClientContext context;
    grpc::health::v1::HealthCheckRequest request;
    request.set_service("jostle.v1.QueryService");
    grpc::health::v1::HealthCheckResponse response;
    const grpc::Status status =
        grpc::health::v1::Health::NewStub(channel)->Check(&context, request, &response);
    EXPECT_TRUE(status.ok()) << status.error_message();
    EXPECT_EQ(response.status(), grpc::health::v1::HealthCheckResponse::SERVING);

    grpc::ClientContext too_much_context;
    v1::CastRaysRequest too_much;
    for (int i = 0; i < 1001; i++) too_much.add_rays();
    v1::CastRaysResponse hits;
    const grpc::Status refused =
        v1::QueryService::NewStub(channel)->CastRays(&too_much_context, too_much, &hits);
    EXPECT_EQ(refused.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
    EXPECT_EQ(refused.error_message(), "rays has 1001 entries; at most 1000 are allowed");
}

// A ServerReflectionRequest that lists services is field 7 with an empty string. The response
// contains the names as plain text.
TEST_F(QueryAndEvents, reflection_lists_the_service) {
    grpc::GenericStub stub(
        grpc::CreateChannel(server.grpc_address(), grpc::InsecureChannelCredentials()));
    grpc::ClientContext context;
    context.set_deadline(std::chrono::system_clock::now() + 5s);
    grpc::CompletionQueue queue;
    const auto stream = stub.PrepareCall(
        &context, "/grpc.reflection.v1alpha.ServerReflection/ServerReflectionInfo", &queue);
    int tag = 0;
    const auto done = [&] {
        void* which = nullptr;
        bool ok = false;
        return queue.Next(&which, &ok) && ok;
    };
    stream->StartCall(&tag);
    ASSERT_TRUE(done());
    const grpc::Slice question(std::string("\x3a\x00", 2));
    stream->Write(grpc::ByteBuffer(&question, 1), &tag);
    ASSERT_TRUE(done());
    grpc::ByteBuffer received;
    stream->Read(&received, &tag);
    ASSERT_TRUE(done());
    grpc::Slice answer;
    ASSERT_TRUE(received.DumpToSingleSlice(&answer).ok());
    const std::string text(reinterpret_cast<const char*>(answer.begin()), answer.size());
    for (const char* service :
         {"jostle.v1.PlayService", "jostle.v1.QueryService", "jostle.v1.WorldService"})
        EXPECT_NE(text.find(service), std::string::npos) << service;
    context.TryCancel();
    grpc::Status status;
    stream->Finish(&status, &tag);
    queue.Shutdown();
    done();
}

}  // namespace
}  // namespace jostle::test
