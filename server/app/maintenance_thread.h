// SPDX-License-Identifier: MIT
//
// What is to be done now and then: looks every second whether keys and certificates have changed
// and which clients will not come back any more, reads them at once on SIGHUP, and tells systemd
// that the server is well while it is. Has a thread of its own for as long as it lives.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <csignal>
#include <functional>
#include <thread>

#include "server/auth/authorizer.h"
#include "server/tls/certificate_store.h"

namespace jostle::server {

class MaintenanceThread {
public:
    // Gate and certificates outlive it; null certificates: there are none. `every_second`,
    // `is_healthy`: any thread.
    MaintenanceThread(Authorizer& authorizer, CertificateStore* certificates,
                      std::function<void()> every_second, std::function<bool()> is_healthy);
    ~MaintenanceThread();

private:
    void wait_for_signal();
    void poll_files();
    void ping_watchdog();

    Authorizer& authorizer_;
    CertificateStore* const certificates_;
    const std::function<void()> every_second_;
    const std::function<bool()> is_healthy_;
    boost::asio::io_context io_{1};
    boost::asio::signal_set signals_{io_, SIGHUP};
    boost::asio::steady_timer timer_{io_}, watchdog_timer_{io_};
    std::thread thread_;
};

}  // namespace jostle::server
