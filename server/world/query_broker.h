// SPDX-License-Identifier: MIT
//
// Where those who ask and the world's thread meet. A question marks interest; while there is any,
// the world's thread leaves a copy with each tick, and for a second after the last question none is
// made any more. The world's thread never waits here: the lock is held for as long as a pointer
// takes to change hands, and copies are freed outside of it.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>

#include "server/util/clock.h"
#include "server/world/query_frame.h"

namespace jostle::server {

class QueryBroker {
public:
    static constexpr std::uint32_t age_ticks_max = 3;  // of a copy that is good enough
    static constexpr auto timeout = std::chrono::milliseconds(250);
    static constexpr auto request_lifetime =
        std::chrono::seconds(1);  // how long a question keeps it up

    // Any thread: a copy with at least these parts. Null: the world left none in time, or is
    // closed.
    QueryFramePtr acquire(CopyLayers layers);
    // Any thread: the same interest, without waiting.
    void request(CopyLayers layers, Clock::time_point now);

    // The world's thread, once per tick: what is asked for. When nothing is, the last copy is
    // dropped.
    CopyLayers begin_tick(std::uint32_t tick, Clock::time_point now);
    void put(QueryFramePtr frame);
    // Any thread: nobody waits any longer, and nobody is answered.
    void close();

private:
    bool is_good(CopyLayers layers) const;  // under the lock

    std::array<std::atomic<Clock::rep>, copy_layer_count> requested_until_{};  // of each part
    std::atomic<std::uint32_t> newest_tick_{0};
    std::mutex mutex_;
    std::condition_variable changed_;
    QueryFramePtr frame_;
    bool closed_ = false;
};

}  // namespace jostle::server
