// SPDX-License-Identifier: MIT
#include "server/app/shutdown.h"

#include "jostle/base/check.h"
#include "server/app/service_manager.h"
#include "server/util/log.h"

namespace jostle::server {

namespace {

constexpr auto poll_period = std::chrono::milliseconds(100);
constexpr auto operator_poll_period = std::chrono::milliseconds(250);
constexpr auto notice_flush_time = std::chrono::milliseconds(100);

}  // namespace

Shutdown::Shutdown(bool handle_signals) {
    if (!handle_signals) return;
    signals_.add(SIGTERM);
    signals_.add(SIGINT);
}

void Shutdown::wait(double drain_timeout_seconds, GrpcServer& grpc, HttpServer& http_server,
                    PlayContext& context) {
    drain_ = from_seconds(drain_timeout_seconds);
    grpc_ = &grpc;
    http_server_ = &http_server;
    context_ = &context;
    await_signal();
    await_operator();
    io_.run();
}

void Shutdown::await_signal() {
    signals_.async_wait([this](const boost::system::error_code& error, int) {
        if (error) return;
        if (begun_) return io_.stop();
        begin();
        await_signal();
    });
}

void Shutdown::await_operator() {
    if (begun_) return;
    if (context_->drain_requested) return begin();
    operator_timer_.expires_after(operator_poll_period);
    operator_timer_.async_wait([this](const boost::system::error_code&) { await_operator(); });
}

void Shutdown::begin() {
    ASSERT(!begun_ && grpc_ && http_server_ && context_);
    begun_ = true;
    log_info("draining: notifying {} clients", context_->sessions.clients());
    notify_stopping();
    context_->draining = true;
    grpc_->drain(drain_);
    wake();
    deadline_ = Clock::now() + drain_;
    wait_for_clients();
}

void Shutdown::wait_for_clients() {
    if (context_->sessions.clients() == 0 || Clock::now() >= deadline_) return finish();
    timer_.expires_after(poll_period);
    timer_.async_wait([this](const boost::system::error_code&) { wait_for_clients(); });
}

// Sends the remaining clients a final notice and waits until the listeners have flushed it.
void Shutdown::finish() {
    context_->closing = true;
    wake();
    timer_.expires_after(notice_flush_time);
    timer_.async_wait([this](const boost::system::error_code&) { io_.stop(); });
}

void Shutdown::wake() {
    grpc_->wake();
    http_server_->wake();
}

}  // namespace jostle::server
