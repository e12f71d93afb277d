// SPDX-License-Identifier: MIT
#include "server/world/query_broker.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {

bool QueryBroker::is_usable(CopyLayers layers) const {
    return frame_ && (frame_->layers & layers) == layers &&
           frame_->tick + usable_ticks_.load(std::memory_order_relaxed) >=
               newest_tick_.load(std::memory_order_relaxed);
}

void QueryBroker::request(CopyLayers layers, Clock::time_point now) {
    ASSERT(layers < 1U << copy_layer_count);
    const Clock::rep until = (now + request_lifetime).time_since_epoch().count();
    for (std::size_t i = 0; i < requested_until_.size(); i++)
        if (layers >> i & 1) requested_until_[i].store(until, std::memory_order_relaxed);
}

bool QueryBroker::is_requested(CopyLayers layers) const {
    const Clock::rep now = Clock::now().time_since_epoch().count();
    for (std::size_t i = 0; i < requested_until_.size(); i++)
        if ((layers >> i & 1) && requested_until_[i].load(std::memory_order_relaxed) > now)
            return true;
    return false;
}

QueryFramePtr QueryBroker::acquire(CopyLayers layers) {
    request(layers, Clock::now());
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, timeout, [&] { return closed_ || is_usable(layers); });
    return !closed_ && is_usable(layers) ? frame_ : nullptr;
}

CopyLayers QueryBroker::begin_tick(std::uint32_t tick, Clock::time_point now) {
    ASSERT(tick >= newest_tick_.load(std::memory_order_relaxed));
    newest_tick_.store(tick, std::memory_order_relaxed);
    CopyLayers layers = 0;
    for (std::size_t i = 0; i < requested_until_.size(); i++)
        if (requested_until_[i].load(std::memory_order_relaxed) > now.time_since_epoch().count())
            layers |= CopyLayers{1} << i;
    if (layers == 0) put(nullptr);
    balance_ = std::min(balance_ + copy_seconds_, copy_seconds_);
    return balance_ < 0 ? 0 : layers;
}

void QueryBroker::charge(double cpu_seconds) {
    ASSERT(!(cpu_seconds < 0));
    if (copy_seconds_ == 0) return;
    balance_ -= cpu_seconds;
    const double ticks = std::ceil(cpu_seconds / copy_seconds_) + 1;
    usable_ticks_.store(std::clamp(static_cast<std::uint32_t>(std::min(ticks, 1e6)), age_ticks_max,
                                   slow_age_ticks_max),
                        std::memory_order_relaxed);
}

void QueryBroker::put(QueryFramePtr frame) {
    const bool has_frame = frame != nullptr;
    {
        const std::lock_guard lock(mutex_);
        frame_.swap(frame);
    }
    if (has_frame) changed_.notify_all();
}

void QueryBroker::close() {
    {
        const std::lock_guard lock(mutex_);
        closed_ = true;
    }
    changed_.notify_all();
}

}  // namespace jostle::server
