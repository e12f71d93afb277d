// SPDX-License-Identifier: MIT
//
// Passes query frames from the tick thread to the threads that run queries. A request marks layers
// as wanted for one second; while layers are wanted, the tick thread puts a query frame in each
// tick, or less often if its copies take more than their share of the ticks. The tick thread never
// blocks here: the lock is held only for the swap of a pointer, and
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
    // Age of a frame that acquire() returns; with copies in fewer ticks, up to the longer limit.
    static constexpr std::uint32_t age_ticks_max = 3, slow_age_ticks_max = 30;
    static constexpr auto timeout = std::chrono::milliseconds(250);
    static constexpr auto request_lifetime = std::chrono::seconds(1);

    // `copy_seconds`: processor time of copies per tick, on average; 0: unlimited.
    explicit QueryBroker(double copy_seconds = 0) : copy_seconds_(copy_seconds) {}

    // Any thread: a frame with at least these layers. Null: the tick thread put none in time, or
    // the broker is closed.
    QueryFramePtr acquire(CopyLayers layers);
    // Any thread: requests the layers without waiting.
    void request(CopyLayers layers, Clock::time_point now);
    // Any thread: whether some of these layers are wanted.
    bool is_requested(CopyLayers layers = (1U << copy_layer_count) - 1) const;

    // The tick thread, once per tick: returns the layers to copy. Drops the last frame if none are
    // wanted.
    CopyLayers begin_tick(std::uint32_t tick, Clock::time_point now);
    void put(QueryFramePtr frame);
    // The tick thread, after a copy: its processor time.
    void charge(double cpu_seconds);
    // Any thread: waiting and later acquire() calls return null.
    void close();

private:
    bool is_usable(CopyLayers layers) const;  // under the lock

    const double copy_seconds_;
    double balance_ = 0;  // of the tick thread, s; negative: a debt
    std::atomic<std::uint32_t> usable_ticks_{age_ticks_max};
    std::array<std::atomic<Clock::rep>, copy_layer_count> requested_until_{};  // per layer
    std::atomic<std::uint32_t> newest_tick_{0};
    std::mutex mutex_;
    std::condition_variable changed_;
    QueryFramePtr frame_;
    bool closed_ = false;
};

}  // namespace jostle::server
