// SPDX-License-Identifier: MIT
//
// Simulates a complete server in one thread, faster than real time: worlds, sessions and clients,
// slow and broken connections, pauses of the machine, worlds that are paused, deleted and
// recreated, and process restarts. It has its own clock and seeded random numbers; the same seed
// gives the same run.
//
// It checks continuously that honest clients decode the exact state of the world, that each of
// their inputs has one result and is applied once, and that a client that leaves leaves nothing
// behind.
#pragma once

#include <array>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tests/simulation/honest_client.h"
#include "tests/simulation/hostile_client.h"

namespace jostle::simulation {

class Simulation {
public:
    explicit Simulation(std::uint64_t seed);
    ~Simulation();

    // Runs `ticks` more ticks, or until a guarantee is violated.
    void run(std::uint64_t ticks);
    // The first violated guarantee; empty: none.
    const std::string& failure() const { return failure_; }
    const Tally& tally() const { return tally_; }
    std::uint64_t ticks() const { return ticks_; }
    // Hash of the state of the worlds and of all counts. The same seed gives the same fingerprint.
    std::uint64_t fingerprint() const;

private:
    struct Server;
    struct ClientSlot {  // used by one honest client after another
        std::unique_ptr<HonestClient> client;
        Clock::time_point again{};  // time of the next connection
    };

    void fail(const std::string& what);
    void start_server();
    void tick();
    void faults();
    void pause_machine();
    void end_cycle();
    bool all_clients_left() const;
    void check_no_leaks();
    std::shared_ptr<NetworkLine> new_line(const std::string& name, bool is_honest);
    void serve_lines();
    void act_honest(ClientSlot& slot);
    void act_hostile();
    server::FramePtr frame_of(std::uint32_t tick) const;

    Chance chance_;
    Tally tally_;
    std::string failure_;
    std::uint64_t ticks_ = 0, lines_made_ = 0;
    Clock::time_point now_ = Clock::time_point() + std::chrono::seconds(1000);
    std::unique_ptr<Server> server_;
    std::vector<std::shared_ptr<NetworkLine>> lines_;
    std::deque<server::FramePtr> frames_;  // frames of the last seconds of the current world
    std::array<ClientSlot, 3> slots_;
    std::unique_ptr<HostileClient> hostile_;
    Clock::time_point hostile_again_{}, resume_at_{}, restart_at_{};
    bool emptying_ = false;
};

}  // namespace jostle::simulation
