// SPDX-License-Identifier: MIT
//
// Periodic maintenance on a thread of its own. Each second it reloads changed keys and
// certificates and calls `every_second`, which removes clients whose resume timeout expired. SIGHUP
// reloads keys and certificates at once. While the server is healthy, it pings systemd's watchdog.
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
    // `authorizer` and `certificates` must outlive this object; null certificates: no TLS. The
    // functions are called on the maintenance thread.
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
