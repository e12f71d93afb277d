// SPDX-License-Identifier: MIT
#include "server/world/tick_watchdog.h"

#include <spdlog/fmt/fmt.h>

#include "server/util/log.h"

namespace jostle::server {

namespace {

constexpr auto period = std::chrono::milliseconds(100);

}  // namespace

TickWatchdog::TickWatchdog(WorldDirectory& worlds, Settings settings)
    : worlds_(worlds),
      settings_(settings),
      checked_at_(Clock::now().time_since_epoch().count()),
      thread_([this] { run(); }) {}

TickWatchdog::~TickWatchdog() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    wake_.notify_all();
    thread_.join();
}

bool TickWatchdog::all_worlds_tick(Clock::time_point now) const {
    const Clock::time_point checked_at{Clock::duration(checked_at_.load())};
    return !hung_ && now - checked_at < settings_.hung_after;
}

void TickWatchdog::check(Clock::time_point now) {
    const Clock::time_point checked_at{Clock::duration(checked_at_.load())};
    bool hung = false;
    for (const auto& world : worlds_.list()) {
        const auto began = world->lifecycle().tick_began();
        if (!began || world->lifecycle().stopped()) continue;
        const Clock::duration took = now - *began;
        hung = hung || took > settings_.hung_after;
        // After a stall of the process the running tick gets the full time again.
        if (took <= settings_.step_max || now - checked_at > process_stall_min ||
            world->lifecycle().paused())
            continue;
        world->interrupt(fmt::format("a step took longer than {:.1f} s", to_ms(took) / 1000));
    }
    hung_ = hung && now - checked_at <= process_stall_min;
    checked_at_ = now.time_since_epoch().count();
    worlds_.restart_failed(now);
}

void TickWatchdog::run() {
    std::unique_lock lock(mutex_);
    while (!wake_.wait_for(lock, period, [&] { return stopping_; })) {
        lock.unlock();
        check(Clock::now());
        lock.lock();
    }
}

}  // namespace jostle::server
