// SPDX-License-Identifier: MIT
//
// A whole server in one thread and in no time: worlds, conversations, what clients are, lines that
// are slow or break, pauses of the machine, worlds that are paused, deleted and made anew, restarts
// of the process. Time is its own, chance comes from a seed, and the same seed does the same again.
//
// What must hold is checked all along: what honest clients decode is the state of the world, each
// of their inputs is answered once and applied once, who leaves leaves nothing behind.
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

    // So many ticks more, or until a promise is broken.
    void run(std::uint64_t ticks);
    // The first promise that was broken; empty: none.
    const std::string& failure() const { return complaint_; }
    const Tally& tally() const { return tally_; }
    std::uint64_t ticks() const { return ticks_; }
    // A word for the state of the worlds and of all that was counted: the same seed, the same word.
    std::uint64_t fingerprint() const;

private:
    struct Server;
    struct ClientSlot {  // for one honest client after the other
        std::unique_ptr<HonestClient> client;
        Clock::time_point again{};  // comes, or comes again
    };

    void fail(const std::string& what);
    void start_server();
    void tick();
    void faults();
    void pause_of_machine();
    void restart_server();
    bool all_clients_left() const;
    void check_no_leaks();
    std::shared_ptr<NetworkLine> new_line(const std::string& name, bool is_honest);
    void serve_lines();
    void act_honest(ClientSlot& seat);
    void act_hostile();
    server::FramePtr frame_of(std::uint32_t tick) const;

    Chance chance_;
    Tally tally_;
    std::string complaint_;
    std::uint64_t ticks_ = 0, lines_made_ = 0;
    Clock::time_point now_ = Clock::time_point() + std::chrono::seconds(1000);
    std::unique_ptr<Server> server_;
    std::vector<std::shared_ptr<NetworkLine>> lines_;
    std::deque<server::FramePtr> frames_;  // the last seconds of the world in which people play
    std::array<ClientSlot, 3> seats_;
    std::unique_ptr<HostileClient> hostile_;
    Clock::time_point hostile_again_{}, resume_at_{}, restart_at_{};
    bool night_ = false;
};

}  // namespace jostle::simulation
