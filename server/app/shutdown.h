// SPDX-License-Identifier: MIT
//
// The drain of a server, started by a signal (SIGTERM, SIGINT) or an operator's Drain call. Signals
// are caught from construction on, so that a signal during the start is not lost. One thread.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <csignal>

#include "server/grpc/grpc_server.h"
#include "server/http/http_server.h"
#include "server/session/play_context.h"

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

}  // namespace jostle::server
