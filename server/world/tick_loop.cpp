// SPDX-License-Identifier: MIT
#include "server/world/tick_loop.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

// Rests end at multiples of this time, so that many resting worlds share few wake-ups of a thread.
constexpr Clock::duration rest_grid = std::chrono::milliseconds(50);

Clock::time_point end_of_rest(Clock::time_point earliest) {
    const Clock::duration past = earliest.time_since_epoch() % rest_grid;
    return past == Clock::duration::zero() ? earliest : earliest + (rest_grid - past);
}

}  // namespace

TickLoop::~TickLoop() {
    ASSERT(!pool_ || (ends_ && !runs_));
}

void TickLoop::start(std::shared_ptr<TickPool> pool, const Settings& settings,
                     Clock::time_point epoch, Run run, std::function<bool()> stopped,
                     std::function<void(const char*)> on_error) {
    ASSERT(!pool_ && pool && run && stopped && settings.rest_ticks >= 1);
    settings_ = settings;
    clock_.emplace(epoch, settings.hz, settings.catch_up_ticks_max);
    clock_->set_hz(settings.speed * settings.hz);
    run_ = std::move(run);
    stopped_ = std::move(stopped);
    on_error_ = std::move(on_error);
    wake_at_ = clock_->next_due();
    pool_ = std::move(pool);
    pool_->add(*this);
}

void TickLoop::stop() {
    if (pool_) pool_->remove(*this);
}

void TickLoop::wake() {
    woken_.store(true);
    if (rests_.load()) pool_->wake(*this);
}

void TickLoop::end_rest() {
    rests_.store(false);
    wake_at_ = clock_->next_due();
}

int TickLoop::rest_ticks_max() const {
    const double in_grid = to_ms(rest_grid) / 1000 * settings_.hz * std::max(1.0, settings_.speed);
    return settings_.rest_ticks + static_cast<int>(std::ceil(in_grid));
}

bool TickLoop::run_due() {
    const Clock::time_point begun = Clock::now();
    const bool rested = rests_.exchange(false);
    woken_.store(false);
    bool may_rest = false;
    try {
        for (int left = clock_->due(begun, rested ? rest_ticks_max() : 0); left > 0; left--) {
            if (stopped_()) return false;
            const Clock::time_point due = clock_->begin_tick();
            may_rest =
                run_({.due = due, .late_ticks = clock_->late_ticks(), .following = left - 1});
        }
    } catch (const std::exception& error) {
        on_error_(error.what());
        return false;
    }
    if (stopped_()) return false;
    last_run_ = Clock::now() - begun;
    rests_.store(may_rest && settings_.rest_ticks > 1);
    if (rests_.load() && woken_.load()) rests_.store(false);
    wake_at_ = rests_.load() ? end_of_rest(clock_->next_due(settings_.rest_ticks - 1))
                             : clock_->next_due();
    return true;
}

}  // namespace jostle::server
