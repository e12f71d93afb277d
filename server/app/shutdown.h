// SPDX-License-Identifier: MIT
//
// The drain of a server, started by a signal (SIGTERM, SIGINT) or an operator's Drain call. Signals
// are caught from construction on, so that a signal during the start is not lost. One thread.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <condition_variable>
#include <csignal>
#include <mutex>
#include <thread>

#include "server/grpc/grpc_server.h"
#include "server/http/http_server.h"
#include "server/session/play_context.h"
#include "server/util/clock.h"

namespace jostle::server {

class Shutdown {
public:
    // `handle_signals` false: only an operator or ServerApp::drain() starts the drain.
    explicit Shutdown(bool handle_signals);

    // Blocks until the drain starts, then until every client has left or `drain_timeout_seconds`
    // have passed. Another signal ends the wait at once.
    void wait(double drain_timeout_seconds, GrpcServer& grpc, HttpServer& http_server,
              PlayContext& context);

private:
    void await_signal();
    void await_operator();
    void begin();
    void wait_for_clients();
    void finish();
    void wake();

    Clock::duration drain_{};
    GrpcServer* grpc_ = nullptr;
    HttpServer* http_server_ = nullptr;
    PlayContext* context_ = nullptr;
    boost::asio::io_context io_{1};
    boost::asio::signal_set signals_{io_};
    boost::asio::steady_timer timer_{io_}, operator_timer_{io_};
    bool begun_ = false;
    Clock::time_point deadline_{};
};

// Ends the process if the shutdown takes longer than a timeout, so that a hanging thread cannot
// block a supervisor.
class ShutdownWatchdog {
public:
    static constexpr int exit_status = 3;

    // The timeout starts now.
    explicit ShutdownWatchdog(Clock::duration timeout);
    ~ShutdownWatchdog();  // cancels it

private:
    std::mutex mutex_;
    std::condition_variable ended_;
    bool done_ = false;
    std::thread thread_;
};

}  // namespace jostle::server
