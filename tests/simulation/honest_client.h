// SPDX-License-Identifier: MIT
//
// A well-behaved client on an impaired connection: it plays, leaves and connects again. It checks
// the guarantees of the protocol: each input has one result, and the decoded state equals the
// server's world.
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

// Receives a description of a violated guarantee; ends the run.
using FailureHandler = std::function<void(const std::string&)>;

// Counts of a run.
struct Tally {
    std::uint64_t connections = 0, snapshots = 0, inputs = 0, applied = 0, refused = 0;
    std::uint64_t resumed = 0;  // connections that resumed a session
    std::uint64_t spawned = 0, frames_compared = 0, hostile_messages = 0, faults = 0;
};

class HonestClient {
public:
    HonestClient(std::string name, std::uint64_t seed, Tally& tally, FailureHandler fail);

    // The frame of a recent tick; null: no longer stored.
    using FrameOf = std::function<server::FramePtr(std::uint32_t tick)>;

    void connect(std::shared_ptr<NetworkLine> line, Clock::time_point now);
    // Receives messages, decides and sends messages.
    void act(Clock::time_point now, const FrameOf& frame_of);
    void leave() { protocol_.leave(); }
    bool is_connected() const { return line_ != nullptr; }
    bool has_left() const { return protocol_.leaving(); }

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
    const FailureHandler fail_;
    client::PlayProtocol protocol_;
    bot::Behaviour behaviour_;
    std::shared_ptr<NetworkLine> line_;
    Clock::time_point connected_at_{};
    bool is_new_line_ = false;  // no Welcome was received on this connection
    std::uint64_t resumed_ = 0;
    // State of the present session: sequences of inputs, and entities.
    std::uint32_t last_sequence_ = 0, last_result_ = 0, carried_over_ = 0;
    std::uint64_t sends_ = 0;  // over all connections
    std::set<std::uint32_t> pending_spawns_, spawned_;
    // owned entities without a result, and the act since which they exist
    std::map<std::uint32_t, std::uint64_t> unexplained_;
    std::uint64_t acts_ = 0;
    std::uint64_t snapshots_ = 0, decode_errors_ = 0;
};

}  // namespace jostle::simulation
