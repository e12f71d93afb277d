// SPDX-License-Identifier: MIT
//
// C++ clients that use datagrams, connected to a server in this process over a network path that
// loses packets, that is blocked from the start, or that becomes blocked.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <random>
#include <set>
#include <thread>

#include "jostle/client/client.h"
#include "jostle/client/predictor.h"
#include "jostle/scenes/catalog.h"
#include "server/grpc/grpc_server.h"
#include "server/services/world_control.h"
#include "tests/server/server_parts.h"
#include "tests/support/wait_until.h"

namespace jostle::server {
namespace {

using namespace std::chrono_literals;
using client::Client;
using test::wait_until;

// Relays datagrams between one client and a server on the loopback device and drops a percentage of
// them. Runs in its own thread; the settings can be changed at any time.
class UdpProxy {
public:
    UdpProxy() : clients_(bound()), servers_(bound()), port_(port_of(clients_)) {}
    ~UdpProxy() {
        stop_ = true;
        if (thread_.joinable()) thread_.join();
        close(clients_);
        close(servers_);
    }
    UdpProxy(const UdpProxy&) = delete;
    UdpProxy& operator=(const UdpProxy&) = delete;

    std::uint16_t port() const { return port_; }
    void start(std::uint16_t server) {
        server_ = server;
        thread_ = std::thread([this] { run(); });
    }

    std::atomic<int> up_loss_percent{0}, down_loss_percent{0};
    std::atomic<int> up{0}, down{0};  // received packets, including dropped ones

private:
    static int bound() {
        const int descriptor = socket(AF_INET, SOCK_DGRAM, 0);
        sockaddr_in address = loopback(0);
        EXPECT_EQ(bind(descriptor, reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
        return descriptor;
    }
    static sockaddr_in loopback(std::uint16_t port) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(port);
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        return address;
    }
    static std::uint16_t port_of(int descriptor) {
        sockaddr_in address{};
        socklen_t size = sizeof address;
        getsockname(descriptor, reinterpret_cast<sockaddr*>(&address), &size);
        return ntohs(address.sin_port);
    }
    bool loses(int percent) { return static_cast<int>(random_() % 100) < percent; }

    void run() {
        sockaddr_in client = loopback(0), server = loopback(server_);
        std::array<pollfd, 2> sockets{pollfd{.fd = clients_, .events = POLLIN, .revents = 0},
                                      pollfd{.fd = servers_, .events = POLLIN, .revents = 0}};
        std::array<char, 2000> packet;
        while (!stop_) {
            if (poll(sockets.data(), sockets.size(), 20) <= 0) continue;
            if (sockets[0].revents != 0) {
                socklen_t size = sizeof client;
                const ssize_t bytes = recvfrom(clients_, packet.data(), packet.size(), 0,
                                               reinterpret_cast<sockaddr*>(&client), &size);
                up++;
                if (bytes > 0 && !loses(up_loss_percent))
                    sendto(servers_, packet.data(), static_cast<std::size_t>(bytes), 0,
                           reinterpret_cast<sockaddr*>(&server), sizeof server);
            }
            if (sockets[1].revents != 0) {
                const ssize_t bytes = recv(servers_, packet.data(), packet.size(), 0);
                down++;
                if (bytes > 0 && !loses(down_loss_percent))
                    sendto(clients_, packet.data(), static_cast<std::size_t>(bytes), 0,
                           reinterpret_cast<sockaddr*>(&client), sizeof client);
            }
        }
    }

    const int clients_, servers_;
    const std::uint16_t port_;
    std::uint16_t server_ = 0;
    std::mt19937 random_{7};
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

v1::Input ball_at(double height) {
    v1::Input input;
    input.mutable_spawn()->mutable_shape()->mutable_sphere()->set_radius(0.2);
    input.mutable_spawn()->mutable_position()->set_y(height);
    return input;
}

class DatagramsTest : public testing::Test, protected ServerParts {
protected:
    DatagramsTest() : ServerParts(4, 4, {.on_frame = [this](bool) { server.wake(); }}) {
        context.datagrams = &port;
    }
    void SetUp() override {
        ASSERT_TRUE(port.start().ok());
        proxy.start(port.port());
        ASSERT_TRUE(server.start().ok());
        scenes::SceneDescription scene = *scenes::find_scene("stack");
        scenes::SceneBody top = scene.bodies[1];  // rotates, so that the world always moves
        top.body.pose.position = {0, 30, 0};
        top.body.angular_velocity = {0, 2, 1};
        top.body.gravity_scale = 0;
        top.body.sleep_allowed = false;
        scene.bodies.push_back(top);
        ASSERT_TRUE(worlds.create("", scene).ok());
    }
    void TearDown() override {
        worlds.stop_all();  // stop the worlds before the objects that they notify
        port.stop();
        context.closing = true;
        server.drain({});
        server.wake();
        server.stop();
    }
    std::shared_ptr<Client> join(bool events = false) {
        return Client::connect(loop, {.target = "127.0.0.1:" + std::to_string(server.port()),
                                      .events = events,
                                      .datagrams = true});
    }
    static bool uses_datagrams(const Client& client) {
        const std::uint64_t previous = client.stats().datagram_snapshots;
        return wait_until([&] { return client.stats().datagram_snapshots > previous + 20; });
    }
    // Spawns `count` balls, a few at a time, and waits for their results.
    std::vector<v1::InputResult> spawn(Client& client, std::size_t count) {
        std::vector<v1::InputResult> results;
        std::size_t sent = 0;
        EXPECT_TRUE(wait_until([&] {
            if (sent < count && client.send(ball_at(3 + 0.5 * static_cast<double>(sent))) != 0)
                sent++;
            std::this_thread::sleep_for(8ms);
            for (v1::InputResult& result : client.take_results()) results.push_back(result);
            return results.size() >= count;
        }));
        return results;
    }

    UdpProxy proxy;
    DatagramServer port{{.host = "127.0.0.1", .port = 0, .advertised_port = proxy.port()}};
    WorldControl control{context};
    GrpcServer server{context, {}, [] { return true; }, {.port = 0}};
    client::Loop loop;
};

}  // namespace

TEST_F(DatagramsTest, sends_snapshots_by_datagram_and_applies_each_input_once) {
    const auto player = join();
    ASSERT_TRUE(uses_datagrams(*player));
    const auto results = spawn(*player, 20);
    ASSERT_EQ(results.size(), 20u);
    for (std::size_t k = 0; k < results.size(); k++) {
        EXPECT_EQ(results[k].sequence(), k + 1);
        EXPECT_EQ(results[k].code(), v1::INPUT_CODE_APPLIED) << results[k].message();
    }
    EXPECT_EQ(player->stats().inputs_sent, 20u) << "a retransmitted input counts once";
    EXPECT_EQ(player->stats().decode_errors, 0u) << player->stats().last_error;
}

// The state of the controlled entity arrives over the stream, before or after the snapshot of its
// tick.
TEST_F(DatagramsTest, predicts_the_controlled_entity_over_datagrams) {
    ASSERT_TRUE(worlds.create("course", *scenes::find_scene("parkour")).ok());
    client::ClientOptions options{.target = "127.0.0.1:" + std::to_string(server.port())};
    options.world = "course";
    options.channels = {client::motion_channel};
    options.timed_inputs = options.datagrams = true;
    const auto walker = Client::connect(loop, options);
    ASSERT_TRUE(uses_datagrams(*walker));
    client::Predictor predictor;
    v1::Welcome welcome;
    welcome.set_tick_hz(60);
    welcome.mutable_gravity()->set_y(-9.81);
    predictor.begin(welcome);
    std::uint32_t body = 0;
    walker->read([&](const client::WorldView& view) {
        for (const auto& [id, entity] : view.entities())
            if (entity.name() == "walker5") body = id;
    });
    const auto send = [&](v1::Input input) {
        input.set_tick(walker->input_tick(client::Clock::now()));
        predictor.add_input(walker->send(input), input);
    };
    v1::Input possess, walk;
    possess.mutable_possess()->set_entity(body);
    walk.mutable_control()->add_axes(0);
    walk.mutable_control()->add_axes(1000);
    send(possess);
    send(walk);
    predictor.follow(body);
    EXPECT_TRUE(wait_until([&] {
        std::this_thread::sleep_for(4ms);
        predictor.on_results(walker->take_results());
        walker->read([&](const client::WorldView& view) { predictor.on_frame(view); });
        const auto now = client::Clock::now();
        predictor.sample(walker->input_position(now), static_cast<std::int64_t>(client::to_us(now)),
                         walker->interpolated(now));
        return predictor.stats().control_updates >= 30;
    }));
    EXPECT_GT(walker->stats().datagram_snapshots, 60u);
    EXPECT_LT(predictor.stats().control_corrections, 10u) << "of 30, allowing for a loaded machine";
}

TEST_F(DatagramsTest, twenty_percent_loss_only_reduces_the_snapshot_rate) {
    proxy.up_loss_percent = proxy.down_loss_percent = 20;
    const auto player = join(true);
    const auto results = spawn(*player, 40);
    EXPECT_TRUE(uses_datagrams(*player));
    ASSERT_EQ(results.size(), 40u);
    std::uint32_t tick = 0;
    for (std::size_t k = 0; k < results.size(); k++) {
        EXPECT_EQ(results[k].sequence(), k + 1) << "results must arrive in order, each once";
        EXPECT_EQ(results[k].code(), v1::INPUT_CODE_APPLIED) << results[k].message();
        EXPECT_GE(results[k].tick(), tick);
        tick = results[k].tick();
    }
    EXPECT_EQ(player->stats().decode_errors, 0u) << player->stats().last_error;
    std::uint32_t events_tick = 0;
    for (const v1::Events& events : player->take_events()) {
        EXPECT_GT(events.tick(), events_tick) << "the stream delivers events in order";
        EXPECT_EQ(events.missed(), 0u);
        events_tick = events.tick();
    }
    EXPECT_GT(events_tick, 0u);
    EXPECT_GT(proxy.up, 30);
}

TEST_F(DatagramsTest, view_contains_only_entities_with_an_entity_update) {
    proxy.down_loss_percent = 10;
    const auto spawner = join(), watcher = join();
    ASSERT_TRUE(wait_until([&] { return watcher->stats().datagrams; }));
    std::size_t looks = 0, unknown = 0;
    std::thread looker([&] {
        for (const auto end = Clock::now() + 2s; Clock::now() < end;) {
            watcher->read([&](const client::WorldView& view) {
                looks++;
                for (const snapshot::EntityState& entity : view.frame().entities)
                    unknown += view.entities().contains(entity.id) ? 0 : 1;
            });
            std::this_thread::sleep_for(1ms);
        }
    });
    EXPECT_EQ(spawn(*spawner, 45).size(), 45u);
    looker.join();
    EXPECT_GT(looks, 20u);
    EXPECT_EQ(unknown, 0u);
    EXPECT_TRUE(wait_until([&] {
        std::size_t entity_count = 0;
        watcher->read(
            [&](const client::WorldView& view) { entity_count = view.frame().entities.size(); });
        return entity_count == worlds.find("")->frame()->entities.size();
    })) << "the observer must receive all entities";
}

TEST_F(DatagramsTest, blocked_udp_falls_back_to_the_stream_and_is_reported) {
    proxy.up_loss_percent = 100;
    const auto player = join();
    EXPECT_EQ(spawn(*player, 10).size(), 10u);
    EXPECT_TRUE(wait_until([&] {
        return player->stats().last_error.find("no datagrams received") != std::string::npos;
    }));
    EXPECT_FALSE(player->stats().datagrams);
    EXPECT_GT(player->stats().snapshots, 10u);
    EXPECT_EQ(player->stats().datagram_snapshots, 0u);
    EXPECT_GT(proxy.up, 10) << "the client must try datagrams";
    EXPECT_EQ(proxy.down, 0) << "the server must not send to an unvalidated address";
}

TEST_F(DatagramsTest, falls_back_to_the_stream_and_returns_to_datagrams) {
    const auto player = join();
    ASSERT_TRUE(uses_datagrams(*player));
    const auto without_datagrams_within = [&](Clock::duration timeout) {
        const auto cut = Clock::now();
        const auto comes_by_stream = [&] {
            const auto previous = player->stats();
            std::this_thread::sleep_for(100ms);
            const auto now = player->stats();
            return !now.datagrams && now.datagram_snapshots == previous.datagram_snapshots &&
                   now.snapshots > previous.snapshots + 3;
        };
        return wait_until(comes_by_stream) && Clock::now() - cut < timeout;
    };
    proxy.down_loss_percent = 100;
    EXPECT_TRUE(without_datagrams_within(10s)) << "packets to the client are lost";
    proxy.down_loss_percent = 0;
    ASSERT_TRUE(uses_datagrams(*player)) << "datagrams must resume";
    proxy.up_loss_percent = 100;
    EXPECT_TRUE(without_datagrams_within(10s)) << "packets from the client are lost";
    EXPECT_EQ(player->stats().decode_errors, 0u) << player->stats().last_error;
}

TEST_F(DatagramsTest, no_datagram_credentials_without_request_or_with_interest) {
    const auto plain =
        Client::connect(loop, {.target = "127.0.0.1:" + std::to_string(server.port())});
    const auto partial =
        Client::connect(loop, {.target = "127.0.0.1:" + std::to_string(server.port()),
                               .interest = client::AreaOfInterest{.x = 0, .z = 0, .radius = 50},
                               .datagrams = true});
    ASSERT_TRUE(
        wait_until([&] { return plain->stats().snapshots > 3 && partial->stats().snapshots > 3; }));
    EXPECT_EQ(port.connections(), 0u);
    const auto taker = join();
    EXPECT_TRUE(wait_until([&] { return port.connections() == 1; }));
    taker->leave();
    EXPECT_TRUE(wait_until([&] { return port.connections() == 0; }));
}

}  // namespace jostle::server
