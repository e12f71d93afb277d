// SPDX-License-Identifier: MIT
//
// A client as ours are, on a line that may be bad: plays, leaves, comes again. Checks what it is
// promised: each input has one answer, and what it decodes is the state of the server's world.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "clients/bot/behaviour.h"
#include "clients/cpp/core/src/play_protocol.h"
#include "server/world/world_host.h"
#include "tests/simulation/network_line.h"

namespace jostle::simulation {

// What is told of a promise that was broken: ends the run.
using FailureHandler = std::function<void(const std::string&)>;

// Counted over a run.
struct Tally {
    std::uint64_t connections = 0, snapshots = 0, inputs = 0, applied = 0, refused = 0;
    std::uint64_t resumed = 0;  // connections in which a client was the one that it was
    std::uint64_t spawned = 0, frames_compared = 0, hostile_messages = 0, faults = 0;
};

class HonestClient {
public:
    HonestClient(std::string name, std::uint64_t seed, Tally& tally, FailureHandler fail);

    // The frame of a tick not long ago; null: not known any more.
    using FrameOf = std::function<server::FramePtr(std::uint32_t tick)>;

    void connect(std::shared_ptr<NetworkLine> line, Clock::time_point now);
    // Hears, thinks and speaks.
    void act(Clock::time_point now, const FrameOf& frame_of);
    void leave() { conversation_.leave(); }
    bool is_connected() const { return line_ != nullptr; }
    bool has_left() const { return conversation_.leaving(); }

private:
    void on_welcome();
    void receive_messages(Clock::time_point now, const FrameOf& frame_of);
    void send_messages(Clock::time_point now);
    void check_results(const FrameOf& frame_of);
    void check_spawn(const v1::InputResult& result, const FrameOf& frame_of);
    void compare(const server::Frame& truth);
    void end();

    const std::string name_;
    Chance chance_;
    Tally& tally_;
    const FailureHandler complain_;
    client::PlayProtocol conversation_;
    bots::Behaviour behaviour_;
    std::shared_ptr<NetworkLine> line_;
    Clock::time_point connected_at_{};
    bool is_new_line_ = false;  // on which no Welcome has come
    std::uint64_t resumed_ = 0;
    // Of this client of the server: sequences of inputs, and entities.
    std::uint32_t last_sequence_ = 0, answered_ = 0, carried_over_ = 0;
    std::uint64_t sends_ = 0;  // of all connections
    std::set<std::uint32_t> spawns_asked_, spawned_;
    std::map<std::uint32_t, std::uint64_t> unexplained_;  // entities of its own: since which act
    std::uint64_t acts_ = 0;
    std::uint64_t snapshots_ = 0, decode_errors_ = 0;
};

}  // namespace jostle::simulation
