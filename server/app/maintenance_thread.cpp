// SPDX-License-Identifier: MIT
#include "server/app/maintenance_thread.h"

#include <utility>

#include "jostle/base/check.h"
#include "server/app/service_manager.h"
#include "server/util/log.h"

namespace jostle::server {

MaintenanceThread::MaintenanceThread(Authorizer& authorizer, CertificateStore* certificates,
                                     std::function<void()> every_second,
                                     std::function<bool()> is_healthy)
    : authorizer_(authorizer),
      certificates_(certificates),
      every_second_(std::move(every_second)),
      is_healthy_(std::move(is_healthy)) {
    ASSERT(every_second_ && is_healthy_);
    thread_ = std::thread([this] {
        wait_for_signal();
        poll_files();
        ping_watchdog();
        io_.run();
    });
}

MaintenanceThread::~MaintenanceThread() {
    io_.stop();
    thread_.join();
}

void MaintenanceThread::wait_for_signal() {
    signals_.async_wait([this](const boost::system::error_code& error, int) {
        if (error) return;
        log_info("SIGHUP: reloading keys and certificates");
        authorizer_.reload();
        if (certificates_) certificates_->reload(std::chrono::system_clock::now());
        wait_for_signal();
    });
}

void MaintenanceThread::poll_files() {
    timer_.expires_after(std::chrono::seconds(1));
    timer_.async_wait([this](const boost::system::error_code& error) {
        if (error) return;
        authorizer_.poll();
        every_second_();
        if (certificates_) certificates_->poll(std::chrono::system_clock::now());
        poll_files();
    });
}

void MaintenanceThread::ping_watchdog() {
    const auto period = watchdog_period();
    if (!period) return;
    if (is_healthy_()) notify_watchdog();
    watchdog_timer_.expires_after(*period);
    watchdog_timer_.async_wait([this](const boost::system::error_code& error) {
        if (!error) ping_watchdog();
    });
}

}  // namespace jostle::server
