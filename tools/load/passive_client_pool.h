// SPDX-License-Identifier: MIT
//
// Passive clients on several threads, each with an epoll descriptor and every n-th client. A share
// of the clients decodes snapshots. If clients play a script, one client per thread decodes and
// provides the world view for all clients of its thread.
#pragma once

#include <atomic>
#include <memory>
#include <optional>
#include <thread>
#include <vector>

#include "clients/bot/behaviour.h"
#include "tools/load/client_pool.h"
#include "tools/load/passive_client.h"

namespace jostle::load {

// One thread of passive clients.
class PassiveClientThread {
public:
    // Clients first, first + step, ... of the plan, which must outlive this object.
    PassiveClientThread(const LoadOptions& plan, const common::SocketAddress& address, int first,
                        int step, Clock::time_point begun);
    ~PassiveClientThread();

    ClientPool::Progress progress() const;
    void measure() { measure_ = true; }
    LoadMetrics end();

private:
    struct Member {
        std::unique_ptr<PassiveClient> client;
        std::optional<bot::Behaviour> behaviour;
        DataTraffic data;
        Clock::time_point joins_at, thinks_at;
    };

    Member make_member(int number, bool has_view);
    void run();
    void tick_all(Clock::time_point now);
    void think(Member& member, Clock::time_point now);

    const LoadOptions& plan_;
    const common::SocketAddress address_;
    const Clock::time_point start_;
    int epoll_ = -1;
    LoadMetrics metrics_;
    std::vector<Member> members_;
    std::atomic<bool> measure_{false}, stop_{false};
    std::atomic<int> joined_{0};
    std::atomic<std::uint64_t> snapshots_{0}, inputs_{0};
    std::thread thread_;
};

using PassiveClientPool = ThreadedClientPool<PassiveClientThread>;

}  // namespace jostle::load
