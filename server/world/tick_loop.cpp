// SPDX-License-Identifier: MIT
#include "server/world/tick_loop.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <exception>
#include <utility>

#include "jostle/base/check.h"
#include "server/world/tick_clock.h"

namespace jostle::server {

struct TickLoop::Timer {
    boost::asio::io_context io{1};
    boost::asio::steady_timer due{io};
};

TickLoop::TickLoop() : timer_(std::make_unique<Timer>()) {}

TickLoop::~TickLoop() = default;

void TickLoop::start(const Settings& settings, Clock::time_point epoch, Tick tick,
                     std::function<bool()> stopped, std::function<void(const char*)> on_error) {
    ASSERT(!thread_.joinable() && tick && stopped);
    tick_ = std::move(tick);
    stopped_ = std::move(stopped);
    on_error_ = std::move(on_error);
    thread_ = std::thread([this, settings, epoch] { run(settings, epoch); });
}

void TickLoop::stop() {
    timer_->io.stop();
    if (thread_.joinable()) thread_.join();
}

void TickLoop::run(const Settings& settings, Clock::time_point epoch) {
    TickClock clock(epoch, settings.hz, settings.catch_up_ticks_max);
    std::function<void()> wait = [&] {
        timer_->due.expires_at(clock.next_due());
        timer_->due.async_wait([&](const boost::system::error_code& error) {
            if (error || stopped_()) return;
            for (int left = clock.due(Clock::now()); left > 0 && !stopped_(); left--)
                tick_(clock.begin_tick(), clock.late_ticks());
            wait();
        });
    };
    wait();
    try {
        timer_->io.run();
    } catch (const std::exception& error) {
        on_error_(error.what());
    }
}

}  // namespace jostle::server
