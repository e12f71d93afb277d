// SPDX-License-Identifier: MIT
//
// Passes query frames from the tick thread to the threads that run queries. A request marks layers
// as wanted for one second; while layers are wanted, the tick thread puts a query frame in each
// tick. The tick thread never blocks here: the lock is held only for the swap of a pointer, and
// frames are freed outside it.
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
    static constexpr std::uint32_t age_ticks_max = 3;  // of a frame that acquire() returns
    static constexpr auto timeout = std::chrono::milliseconds(250);
    static constexpr auto request_lifetime = std::chrono::seconds(1);

    // Any thread: a frame with at least these layers. Null: the tick thread put none in time, or
    // the broker is closed.
    QueryFramePtr acquire(CopyLayers layers);
    // Any thread: requests the layers without waiting.
    void request(CopyLayers layers, Clock::time_point now);

    // The tick thread, once per tick: returns the wanted layers. Drops the last frame if there are
    // none.
    CopyLayers begin_tick(std::uint32_t tick, Clock::time_point now);
    void put(QueryFramePtr frame);
    // Any thread: waiting and later acquire() calls return null.
    void close();

private:
    bool is_usable(CopyLayers layers) const;  // under the lock

    std::array<std::atomic<Clock::rep>, copy_layer_count> requested_until_{};  // per layer
    std::atomic<std::uint32_t> newest_tick_{0};
    std::mutex mutex_;
    std::condition_variable changed_;
    QueryFramePtr frame_;
    bool closed_ = false;
};

}  // namespace jostle::server
