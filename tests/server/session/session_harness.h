// SPDX-License-Identifier: MIT
//
// A real world, a client library's half of a conversation and the server's half, with a bad link
// between them, in one thread and in no time.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clients/cpp/core/src/play_protocol.h"
#include "jostle/base/network_queue.h"
#include "server/session/client_session.h"

namespace jostle::test {

// Worlds that tick when they are told to, and what their clients need.
struct TestServer {
    explicit TestServer(server::Config with = {}) : config(std::move(with)) {
        config.auth.anonymous_role = "player";
        config.auth.audit_log = "/dev/null";
    }
    std::shared_ptr<server::WorldHost> host(const scenes::SceneDescription& scene) {
        return *worlds.create("yard", scene);
    }

    server::Config config;
    const std::unique_ptr<server::Authorizer> authorizer = *server::Authorizer::open(config);
    server::SessionDirectory sessions{20, 1 << 30, config.limits.sessions_per_subject};
    server::WorldDirectory worlds{
        {.limits = {.scene = {.first_step_seconds_max = 100},
                    .lag_compensation_ms_max = config.tick.lag_compensation_ms_max},
         .own_ticks = false},
        2};
    server::PlayContext context{
        .config = config, .worlds = worlds, .sessions = sessions, .authorizer = *authorizer};
    server::Clock::time_point now = server::Clock::now();
};

struct SessionHarness {
    SessionHarness(TestServer& at, client::ClientOptions options,
                   const NetworkConditions& each_way = {})
        : server(at),
          conversation(std::move(options)),
          settings(each_way),
          outgoing(each_way),
          incoming(each_way) {
        connect();
    }
    void drop_in_flight() {
        outgoing = NetworkQueue<std::string>(settings);
        incoming = NetworkQueue<std::string>(settings);
    }
    // A new connection.
    void connect() {
        session.emplace(server.context,
                        server::Peer{.name = "test",
                                     .address = "127.0.0.1",
                                     .call = "jostle.v1.PlayService/Play",
                                     .who = server.authorizer->identify({.address = "127.0.0.1"})},
                        server.now);
        conversation.begin(server.now);
    }
    // What either side has to say now, and what has arrived.
    void exchange() {
        while (auto said = conversation.take_message(server.now))
            outgoing.push(*std::move(said), server.now);
        while (const auto arrived = outgoing.take(server.now))
            session->receive(*arrived, server.now);
        while (const auto out = session->take_message(server.now)) {
            std::string bytes = out->header + (out->shared ? *out->shared : "");
            for (const server::SharedBytes& field : out->shared_fields) bytes += *field;
            if (tamper) tamper(bytes);
            incoming.push(std::move(bytes), server.now);
        }
        while (const auto arrived = incoming.take(server.now))
            conversation.receive(*arrived, server.now);
    }
    std::vector<client::SmoothPose> draw() {
        return conversation.buffer().sample(static_cast<std::int64_t>(client::to_us(server.now)),
                                            conversation.view().spec());
    }

    TestServer& server;
    client::PlayProtocol conversation;
    NetworkConditions settings;
    NetworkQueue<std::string> outgoing, incoming;
    std::optional<server::ClientSession> session;
    std::function<void(std::string&)> tamper;  // with what the server says
};

// Ticks the world and lets the clients talk, four times a tick.
template <class Each>
void play(TestServer& server, server::WorldHost& world, std::vector<SessionHarness*> clients,
          int ticks, Each&& each) {
    for (int tick = 0; tick < ticks; tick++) {
        world.tick(server.now);
        for (int quarter = 0; quarter < 4; quarter++) {
            for (SessionHarness* client : clients) client->exchange();
            if (quarter == 3) each(tick);
            server.now += std::chrono::nanoseconds(16'666'667 / 4);
        }
    }
}
inline void play(TestServer& server, server::WorldHost& world, std::vector<SessionHarness*> clients,
                 int ticks) {
    play(server, world, std::move(clients), ticks, [](int) {});
}

}  // namespace jostle::test
