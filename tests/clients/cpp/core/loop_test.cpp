// SPDX-License-Identifier: MIT
//
// Connections of the loop to a minimal play service in this process: streams that end, servers that
// stop and owners that destroy their clients early.
#include <grpcpp/server.h>
#include <grpcpp/server_builder.h>
#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <thread>

#include "jostle/client/client.h"
#include "jostle/v1/play.grpc.pb.h"

namespace jostle::client {
namespace {

using PlayCall = grpc::ServerReaderWriter<v1::ServerMessage, v1::ClientMessage>;

// Sends a Welcome and one snapshot of an empty world, then reads until the client leaves. The first
// `streams_to_end` streams end directly after the Welcome.
class Service final : public v1::PlayService::Service {
public:
    std::atomic<int> streams{0}, streams_to_end{0}, inputs{0}, acks{0}, leaves{0};

    grpc::Status Play(grpc::ServerContext*, PlayCall* stream) override {
        const int number = ++streams;
        v1::ClientMessage message;
        if (!stream->Read(&message) || !message.has_hello()) return grpc::Status::CANCELLED;
        v1::ServerMessage welcome;
        welcome.mutable_welcome()->set_client_id(static_cast<std::uint32_t>(number));
        welcome.mutable_welcome()->mutable_quant()->set_units_per_meter(512);
        welcome.mutable_welcome()->mutable_quant()->set_rotation_component(511);
        stream->Write(welcome);
        if (number <= streams_to_end) return {grpc::StatusCode::UNAVAILABLE, "going down"};
        send_empty_world(*stream);
        while (stream->Read(&message)) {
            inputs += message.input().inputs_size();
            acks += message.has_ack() && message.ack().frame() == 5 ? 1 : 0;
            if (message.has_leave()) {
                leaves++;
                break;
            }
        }
        return grpc::Status::OK;
    }

private:
    static void send_empty_world(PlayCall& stream) {
        const snapshot::QuantizedFrame empty{.frame = 5, .entities = {}};
        const auto packed = snapshot::encode_frame(empty, {}, {});
        v1::ServerMessage message;
        message.mutable_snapshot()->set_frame(5);
        message.mutable_snapshot()->set_packed(packed.data(), packed.size());
        message.mutable_snapshot()->set_crc(snapshot::frame_crc(empty));
        stream.Write(message);
    }
};

struct LoopTest : testing::Test {
    Service service;
    int port = 0;
    std::unique_ptr<grpc::Server> server = start();

    std::unique_ptr<grpc::Server> start() {
        grpc::ServerBuilder builder;
        builder.AddListeningPort("127.0.0.1:0", grpc::InsecureServerCredentials(), &port);
        builder.RegisterService(&service);
        return builder.BuildAndStart();
    }
    ~LoopTest() override { server->Shutdown(std::chrono::system_clock::now()); }
    ClientOptions options() const { return {.target = "127.0.0.1:" + std::to_string(port)}; }
};

bool soon(const std::function<bool()>& condition) {
    const auto deadline = Clock::now() + std::chrono::seconds(10);
    while (!condition() && Clock::now() < deadline)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return condition();
}

}  // namespace

TEST_F(LoopTest, joins_acknowledges_sends_and_leaves) {
    Loop loop;
    const auto client = Client::connect(loop, options());
    for (int i = 0; i < 40; i++) client->send({});
    EXPECT_TRUE(soon([&] { return service.inputs == 40 && service.acks + service.inputs > 40; }));
    client->leave();
    EXPECT_TRUE(soon([&] { return service.leaves == 1; }));
    EXPECT_TRUE(soon([&] { return !client->stats().connected; }));
    EXPECT_EQ(client->stats().snapshots, 1u);
    EXPECT_EQ(client->stats().stream_failures, 0u) << client->stats().last_error;
}

TEST_F(LoopTest, reconnects_after_a_stream_ends_and_reports_the_reason) {
    service.streams_to_end = 2;
    Loop loop;
    const auto client = Client::connect(loop, options());
    EXPECT_TRUE(soon([&] { return client->stats().client_id == 3 && client->stats().connected; }));
    client->send({});
    EXPECT_TRUE(soon([&] { return service.inputs == 1; }));
    EXPECT_EQ(client->stats().stream_failures, 2u);
    EXPECT_NE(client->stats().last_error.find("going down"), std::string::npos);
}

TEST_F(LoopTest, does_not_reconnect_when_disabled) {
    service.streams_to_end = 5;
    Loop loop;
    auto once = options();
    once.reconnect = false;
    const auto client = Client::connect(loop, once);
    EXPECT_TRUE(soon([&] { return client->stats().stream_failures == 1; }));
    std::this_thread::sleep_for(std::chrono::milliseconds(600));
    EXPECT_EQ(service.streams, 1);
}

TEST_F(LoopTest, handles_many_clients_destroyed_without_leave) {
    Loop loop;
    std::vector<std::shared_ptr<Client>> clients;
    for (int i = 0; i < 8; i++) clients.push_back(Client::connect(loop, options()));
    EXPECT_TRUE(soon([&] {
        for (const auto& client : clients)
            if (client->stats().snapshots == 0) return false;
        return true;
    }));
    clients.clear();  // the loop cancels their streams and continues
    const auto another = Client::connect(loop, options());
    EXPECT_TRUE(soon([&] { return another->stats().snapshots == 1; }));
}

TEST_F(LoopTest, simulated_network_delays_both_directions) {
    Loop loop;
    auto far = options();
    far.network_conditions.latency_ms = 60;
    const auto began = Clock::now();
    const auto client = Client::connect(loop, far);
    for (int i = 0; i < 40; i++) client->send({});
    EXPECT_TRUE(soon([&] { return client->stats().snapshots == 1; }));
    EXPECT_GE(Clock::now() - began, std::chrono::milliseconds(120));
    client->leave();
    EXPECT_TRUE(soon([&] { return service.leaves == 1; }));
    EXPECT_EQ(service.inputs, 40);
    EXPECT_EQ(client->stats().stream_failures, 0u) << client->stats().last_error;
}

TEST_F(LoopTest, can_be_destroyed_before_its_clients) {
    std::shared_ptr<Client> client;
    {
        Loop loop;
        client = Client::connect(loop, options());
        EXPECT_TRUE(soon([&] { return client->stats().snapshots == 1; }));
    }
    client->send({});
    client->leave();
    EXPECT_EQ(client->stats().snapshots, 1u);
}

TEST(Loop, reports_an_unreachable_server_without_hanging) {
    Loop loop;
    // Port 1 is privileged, so nothing listens on it.
    const auto client = Client::connect(loop, {.target = "127.0.0.1:1"});
    EXPECT_TRUE(soon([&] { return client->stats().stream_failures >= 2; }));
    EXPECT_FALSE(client->stats().last_error.empty());
}

}  // namespace jostle::client
