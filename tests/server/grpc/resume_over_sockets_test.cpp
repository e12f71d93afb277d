// SPDX-License-Identifier: MIT
//
// A C++ client and a server in this process with a relay between them, which the test stops and
// restarts to break the connections.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <thread>

#include "jostle/client/client.h"
#include "server/grpc/grpc_server.h"
#include "tests/server/server_parts.h"
#include "tests/support/small_scene.h"
#include "tests/support/wait_until.h"
#include "tools/network_emulator/tcp_proxy.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using client::Client;
using test::wait_until;

// Relays bytes while it exists.
class Line {
public:
    Line(int server_port, int port)
        : relay_({.target = "127.0.0.1:" + std::to_string(server_port)}) {
        relay_.listen("127.0.0.1:" + std::to_string(port)).expect();
        thread_ = std::thread([this] { relay_.run(stop_); });
    }
    ~Line() {
        stop_ = true;
        thread_.join();
    }
    int port() const { return relay_.port(); }

private:
    network_emulator::TcpProxy relay_;
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

v1::Input small_ball(int number) {
    v1::Input input;
    input.mutable_spawn()->mutable_shape()->mutable_sphere()->set_radius(0.2);
    input.mutable_spawn()->mutable_position()->set_x(number % 5);
    input.mutable_spawn()->mutable_position()->set_y(10 + number / 5);
    return input;
}

class ResumeOverSocketsTest : public testing::Test, protected ServerParts {
protected:
    ResumeOverSocketsTest() : ServerParts(4, 4, {.on_frame = [this](bool) { server.wake(); }}) {}
    void SetUp() override {
        ASSERT_TRUE(worlds.create("yard", test::small_scene()).ok());
        ASSERT_TRUE(server.start().ok());
    }
    void TearDown() override { stop_server(*this, server); }

    GrpcServer server{context, {}, [] { return true; }, {.port = 0}};
    client::Loop loop;
};

TEST_F(ResumeOverSocketsTest, client_resumes_after_three_disconnects_without_loss) {
    auto line = std::make_unique<Line>(server.port(), 0);
    const int port = line->port();
    const auto player =
        Client::connect(loop, {.target = "127.0.0.1:" + std::to_string(port), .name = "player"});
    ASSERT_TRUE(wait_until([&] { return player->stats().snapshots > 5; }));
    const ClientId id = player->stats().client_id;
    std::uint32_t sent = 0;
    for (int round = 1; round <= 3; round++) {
        for (int i = 0; i < 8; i++) {
            sent = player->send(small_ball(static_cast<int>(sent)));
            if (i == 3) line.reset();  // while inputs are being sent
            std::this_thread::sleep_for(5ms);
        }
        line = std::make_unique<Line>(server.port(), port);
        ASSERT_TRUE(wait_until([&] {
            return player->stats().connected &&
                   player->stats().resumed == static_cast<unsigned>(round);
        })) << player->stats().last_error;
    }
    std::set<std::uint32_t> answered;
    EXPECT_TRUE(wait_until([&] {
        for (const v1::InputResult& result : player->take_results()) {
            EXPECT_EQ(result.code(), v1::INPUT_CODE_APPLIED) << result.message();
            EXPECT_TRUE(answered.insert(result.sequence()).second);
        }
        return answered.size() == 24;
    })) << answered.size();
    EXPECT_EQ(sent, 24u);
    EXPECT_EQ(player->stats().client_id, id);
    EXPECT_EQ(player->stats().decode_errors, 0u);
    const auto list = worlds.find("yard")->frame()->entity_list;
    EXPECT_EQ(std::ranges::count_if(*list, [&](const auto& e) { return e->owner == id; }), 24);
    player->leave();
    EXPECT_TRUE(wait_until([&] { return sessions.clients() == 0; }));
}

TEST_F(ResumeOverSocketsTest, destroyed_client_leaves_the_world) {
    auto player = Client::connect(
        loop, {.target = "127.0.0.1:" + std::to_string(server.port()), .name = "player"});
    ASSERT_TRUE(wait_until([&] { return player->stats().connected; }));
    player.reset();
    EXPECT_TRUE(wait_until([&] { return sessions.clients() == 0; }));
    EXPECT_EQ(context.resume_registry.disconnected(), 0u);
}

}  // namespace
}  // namespace jostle::server
