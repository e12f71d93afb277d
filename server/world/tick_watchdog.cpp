// SPDX-License-Identifier: MIT
#include "server/world/tick_watchdog.h"

#include <spdlog/fmt/fmt.h>

#include <utility>

#include "server/util/log.h"

namespace jostle::server {

namespace {

constexpr auto period = std::chrono::milliseconds(100);
// A machine with many busy processes may delay the thread for a second.
constexpr auto alive_max = std::chrono::seconds(5);

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

bool TickWatchdog::is_alive(Clock::time_point now) const {
    const Clock::time_point checked_at{Clock::duration(checked_at_.load())};
    return now - checked_at < alive_max;
}

void TickWatchdog::check(Clock::time_point now) {
    const Clock::time_point checked_at{Clock::duration(checked_at_.load())};
    const bool stalled = now - checked_at > process_stall_min;
    std::set<std::string> hung;
    for (const auto& world : worlds_.list()) {
        if (world->lifecycle().stopped()) continue;
        if (check_tick(*world, now, stalled)) hung.insert(world->id());
        world->resume_if_due(now);
    }
    hung_ = std::move(hung);
    checked_at_ = now.time_since_epoch().count();
    worlds_.restart_failed(now);
    if (TickPool* const pool = worlds_.tick_pool()) pool->add_thread_if_stuck(now);
}

// After a stall of the process, a tick is judged by its processor time only.
bool TickWatchdog::check_tick(WorldHost& world, Clock::time_point now, bool stalled) {
    const auto tick = world.lifecycle().running_tick(now);
    if (tick && tick->cpu > settings_.tick_cpu_max)
        world.interrupt_overloaded(
            fmt::format("a tick used {:.1f} s of processor time", to_ms(tick->cpu) / 1000), now);
    const bool was_hung = hung_.contains(world.id());
    if (stalled) return was_hung;
    const bool is_hung = tick && tick->wall > settings_.hung_after;
    if (is_hung && !was_hung)
        log_warn("world {} \"{}\": a tick has run for {:.1f} s and used {:.1f} s of processor time",
                 world.id(), world.name(), to_ms(tick->wall) / 1000, to_ms(tick->cpu) / 1000);
    if (was_hung && !is_hung)
        log_info("world {} \"{}\": the tick has ended", world.id(), world.name());
    world.tick_metrics().set_hung(is_hung);
    return is_hung;
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
