// SPDX-License-Identifier: MIT
//
// The end of a server: by a signal (SIGTERM, SIGINT) or an operator's word. Signals are caught from
// the moment this exists, so that one that comes while worlds are still built is not lost. One
// thread.
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
    // `handle_signals` false: only an operator or ServerApp::drain() begins it.
    explicit Shutdown(bool handle_signals);

    // Waits for the first of them, then gives clients `drain_timeout_seconds` to leave; a further
    // signal ends the wait.
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

// Ends the process when it has not ended by itself in time: whatever hangs, a supervisor is obeyed.
class ShutdownWatchdog {
public:
    static constexpr int status = 3;

    // From now on.
    explicit ShutdownWatchdog(Clock::duration timeout);
    ~ShutdownWatchdog();  // in time

private:
    std::mutex mutex_;
    std::condition_variable ended_;
    bool done_ = false;
    std::thread thread_;
};

}  // namespace jostle::server
