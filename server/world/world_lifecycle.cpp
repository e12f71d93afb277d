// SPDX-License-Identifier: MIT
#include "server/world/world_lifecycle.h"

#include <algorithm>

#include "jostle/base/check.h"

namespace jostle::server {

bool WorldLifecycle::pause_overloaded(std::string reason, Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    if (paused_) return false;
    if (now - last_resumed_ > overload_reset) next_pause_ = overload_pause;
    const Clock::duration pause = next_pause_;
    ASSERT(pause >= overload_pause && pause <= overload_pause_max);
    next_pause_ = std::min<Clock::duration>(2 * pause, overload_pause_max);
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(pause).count();
    paused_ = std::move(reason) + "; the world resumes after " + std::to_string(seconds) + " s";
    resume_at_ = now + pause;
    return true;
}

bool WorldLifecycle::resume_if_due(Clock::time_point now) {
    const std::lock_guard lock(mutex_);
    if (!resume_at_ || now < *resume_at_) return false;
    ASSERT(paused_);
    paused_.reset();
    resume_at_.reset();
    last_resumed_ = now;
    return true;
}

void WorldLifecycle::begin_tick(Clock::time_point now) {
    tick_thread_.use_this_thread();
    tick_cpu_began_.store(tick_thread_.now().value_or(std::chrono::nanoseconds(0)).count());
    tick_began_.store(now.time_since_epoch().count());
}

// Another tick may begin between the reads; its start differs.
std::optional<WorldLifecycle::TickUse> WorldLifecycle::running_tick(Clock::time_point now) const {
    const Clock::rep began = tick_began_.load();
    if (began == 0) return std::nullopt;
    const std::chrono::nanoseconds cpu_began(tick_cpu_began_.load());
    const std::optional<std::chrono::nanoseconds> cpu = tick_thread_.now();
    if (!cpu || tick_began_.load() != began) return std::nullopt;
    return TickUse{.wall = now - Clock::time_point(Clock::duration(began)),
                   .cpu = *cpu - cpu_began};
}

}  // namespace jostle::server
