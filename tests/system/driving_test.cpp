// SPDX-License-Identifier: MIT
//
// Controlling an entity end to end: the real server, a module of its scene and two kinds of
// clients.
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <cmath>
#include <thread>

#include "tests/system/player.h"
#include "tests/system/server_process.h"

namespace jostle::test {
namespace {

using namespace std::chrono_literals;

v1::Input possess(std::uint32_t entity) {
    v1::Input input;
    input.mutable_possess()->set_entity(entity);
    return input;
}
v1::Input hold(std::initializer_list<int> axes) {
    v1::Input input;
    input.mutable_control();
    for (const int axis : axes) input.mutable_control()->add_axes(axis);
    return input;
}

// The complete result of an input.
v1::InputResult result_of(Player& player, std::uint32_t sequence) {
    EXPECT_TRUE(
        player.wait_until([&](const PlayState& s) { return s.results.contains(sequence); }));
    return player.with_state([&](const PlayState& s) { return s.results.at(sequence); });
}

// Distance from the y axis in the newest snapshot, m.
double distance_of(const PlayState& s, std::uint32_t entity) {
    for (const snapshot::EntityState& state : s.newest()->entities)
        if (state.id == entity)
            return std::hypot(state.position[0], state.position[2]) /
                   s.welcome.quant().units_per_meter();
    return -1;
}

TEST(Driving, only_the_controlling_client_steers_the_hovercraft) {
    ServerProcess server{
        {"--scene", "hovercraft", "--listen", "127.0.0.1:0", "--http", "127.0.0.1:0"}};
    ASSERT_TRUE(server.is_running()) << server.log();
    const auto driver = grpc_player(server.grpc_address());
    const auto other = websocket_player(server.http_port());
    for (Player* player : {driver.get(), other.get()}) {
        player->hello();
        ASSERT_TRUE(player->wait_until([](const PlayState& s) { return s.snapshots > 0; }));
    }
    const std::uint32_t craft = driver->with_state([](const PlayState& s) {
        std::uint32_t found = 0;
        for (const auto& [id, entity] : s.entities) {
            EXPECT_EQ(entity.controllable(), entity.name() == "craft");
            if (entity.controllable()) found = id;
        }
        return found;
    });
    ASSERT_NE(craft, 0u);

    driver->send_inputs({hold({0, 1000}), possess(craft + 1), possess(craft)});
    EXPECT_EQ(result_of(*driver, 1).code(), v1::INPUT_CODE_NOT_FOUND)
        << "the client controls nothing yet";
    EXPECT_EQ(result_of(*driver, 2).message(), "the entity is not controllable");
    EXPECT_EQ(result_of(*driver, 3).code(), v1::INPUT_CODE_APPLIED);
    other->send_inputs({possess(craft)});
    EXPECT_EQ(result_of(*other, 1).message(), "another client controls the entity");

    // Without control it stays on a circle of 11 m; straight ahead at 7 m/s it leaves the circle.
    driver->send_inputs({hold({0, 1000})});
    EXPECT_EQ(result_of(*driver, 4).entity(), craft);
    bool left = false;
    for (int k = 0; k < 300 && !left; k++) {
        driver->send_inputs({});  // batches acknowledge snapshots
        std::this_thread::sleep_for(20ms);
        left = driver->with_state([&](const PlayState& s) { return distance_of(s, craft) > 16; });
    }
    EXPECT_TRUE(left);

    driver->leave();
    ASSERT_TRUE(driver->wait_for_end());
    for (std::uint32_t k = 2; k < 100; k++) {  // until the world has processed the departure
        other->send_inputs({possess(craft)});
        if (result_of(*other, k).code() == v1::INPUT_CODE_APPLIED) break;
        std::this_thread::sleep_for(20ms);
    }
    other->with_state([](const PlayState& s) { EXPECT_EQ(s.count(v1::INPUT_CODE_APPLIED), 1u); });
    server.signal(SIGTERM);
    EXPECT_EQ(server.wait(10s), 0) << server.log();
}

}  // namespace
}  // namespace jostle::test
