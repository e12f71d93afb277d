// SPDX-License-Identifier: MIT
//
// Clients of the C++ client library, like those of a game: each decodes everything. They are
// distributed over several threads, each with a loop of the library for its connections and a
// thread that plays.
#pragma once

#include <atomic>
#include <deque>
#include <memory>
#include <thread>
#include <vector>

#include "clients/bot/bot.h"
#include "tools/load/client_pool.h"
#include "tools/load/load_options.h"

namespace jostle::load {

class LibraryClientThread {
public:
    // Clients first, first + step, ... of the plan, which must outlive this object.
    LibraryClientThread(const LoadOptions& plan, int first, int step, Clock::time_point begun);
    ~LibraryClientThread();

    ClientPool::Progress progress() const;
    void measure() { measure_ = true; }
    LoadMetrics end();

private:
    struct Member {
        std::unique_ptr<bot::Bot> bot;
        client::ClientStats before;  // at the start of the measurement
        DataTraffic data;
    };

    void run();
    void join_due(Clock::time_point now);
    void think(Clock::time_point now);
    void collect(Member& member, Clock::time_point now);
    void begin_measurement(Clock::time_point now);
    void count();

    const LoadOptions& options_;
    const int first_, step_;
    const Clock::time_point start_;
    client::Loop loop_;
    std::vector<Member> members_;
    LoadMetrics metrics_;
    std::atomic<bool> measure_{false}, stop_{false};
    std::atomic<int> joined_{0};
    std::atomic<std::uint64_t> snapshots_{0}, inputs_{0};
    std::thread thread_;
};

using LibraryClientPool = ThreadedClientPool<LibraryClientThread>;

}  // namespace jostle::load
