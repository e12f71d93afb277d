// SPDX-License-Identifier: MIT
#include "server/app/maintenance_thread.h"

#include <utility>

#include "server/app/service_manager.h"
#include "server/util/log.h"

namespace jostle::server {

MaintenanceThread::MaintenanceThread(Gate& gate, CertificateStore* certificates, std::function<void()> every_second,
               std::function<bool()> is_well)
    : gate_(gate),
      certificates_(certificates),
      every_second_(std::move(every_second)),
      is_well_(std::move(is_well)) {
    thread_ = std::thread([this] {
        wait_for_signal();
        look_again();
        tell_again();
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
        log_info("SIGHUP: keys and certificates are read again");
        gate_.reload();
        if (certificates_) certificates_->reload(std::chrono::system_clock::now());
        wait_for_signal();
    });
}

void MaintenanceThread::look_again() {
    timer_.expires_after(std::chrono::seconds(1));
    timer_.async_wait([this](const boost::system::error_code& error) {
        if (error) return;
        gate_.poll();
        every_second_();
        if (certificates_) certificates_->poll(std::chrono::system_clock::now());
        look_again();
    });
}

void MaintenanceThread::tell_again() {
    const auto period = watchdog_period();
    if (!period) return;
    if (is_well_()) notify_watchdog();
    watchdog_timer_.expires_after(*period);
    watchdog_timer_.async_wait([this](const boost::system::error_code& error) {
        if (!error) tell_again();
    });
}

}  // namespace jostle::server
