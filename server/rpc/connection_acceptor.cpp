// SPDX-License-Identifier: MIT
#include "rpc/connection_acceptor.h"

#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "base/log.h"

namespace jostle::server {

namespace {

constexpr int sweep_period_ms = 20;
constexpr int backlog = 1024;
constexpr auto tell_period = std::chrono::seconds(5);
// When no descriptor is left, trying again at once would only spin.
constexpr auto accept_pause = std::chrono::milliseconds(100);
// A peer that acknowledges nothing for so long is gone.
constexpr unsigned silent_peer_ms = 20'000;

template <class Value>
void set_option(int descriptor, int level, int name, Value value) {
    setsockopt(descriptor, level, name, &value, sizeof value);
}

std::uint16_t port_of(int descriptor) {
    sockaddr_storage own{};
    socklen_t size = sizeof own;
    getsockname(descriptor, reinterpret_cast<sockaddr*>(&own), &size);
    return ntohs(reinterpret_cast<const sockaddr_in6&>(own).sin6_port);  // ports lie alike
}

}  // namespace

ConnectionAcceptor::~ConnectionAcceptor() {
    stop();
    if (wake_ >= 0) ::close(wake_);
}

Status ConnectionAcceptor::listen(const std::string& host, std::uint16_t port) {
    const auto failed = [&](const std::string& why) {
        return Error{ErrorCode::unavailable,
                     fmt::format("cannot listen on {}:{} for gRPC: {}; choose another with "
                                 "--listen HOST:PORT",
                                 host, port, why)};
    };
    addrinfo hints{};
    hints.ai_socktype = SOCK_STREAM;
    hints.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
    addrinfo* found = nullptr;
    if (const int e = getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found);
        e != 0)
        return failed(gai_strerror(e));
    const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> owned(found, freeaddrinfo);
    listener_ = socket(found->ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (listener_ < 0) return failed(std::strerror(errno));
    set_option(listener_, SOL_SOCKET, SO_REUSEADDR, 1);
    if (found->ai_family == AF_INET6) set_option(listener_, IPPROTO_IPV6, IPV6_V6ONLY, 0);
    if (bind(listener_, found->ai_addr, found->ai_addrlen) != 0 ||
        ::listen(listener_, backlog) != 0) {
        const int error = errno;
        ::close(std::exchange(listener_, -1));
        return failed(std::strerror(error));
    }
    wake_ = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
    port_ = port_of(listener_);
    return {};
}

void ConnectionAcceptor::start(HandOver hand_over) {
    hand_over_ = std::move(hand_over);
    thread_ = std::thread([this] { run(); });
}

void ConnectionAcceptor::close() {
    closed_ = true;
    if (wake_ >= 0) eventfd_write(wake_, 1);
}

void ConnectionAcceptor::stop() {
    stopping_ = true;
    close();
    if (thread_.joinable()) thread_.join();
    if (listener_ >= 0) ::close(std::exchange(listener_, -1));
}

bool ConnectionAcceptor::is_listening(Clock::time_point now) const {
    const auto since = [&](Clock::rep at) { return now - Clock::time_point(Clock::duration(at)); };
    return since(looked_) < std::chrono::seconds(1) && since(starved_) > 2 * accept_pause;
}

void ConnectionAcceptor::run() {
    while (!stopping_) {
        if (closed_ && listener_ >= 0) ::close(std::exchange(listener_, -1));
        const bool pausing = Clock::now() < accept_again_;
        pollfd ready[2] = {{wake_, POLLIN, 0}, {pausing ? -1 : listener_, POLLIN, 0}};
        poll(ready, 2, sweep_period_ms);
        if (ready[0].revents != 0) {
            eventfd_t ignored = 0;
            eventfd_read(wake_, &ignored);
        }
        if (ready[1].revents != 0 && !closed_) accept_all();
        const Clock::time_point now = Clock::now();
        looked_ = now.time_since_epoch().count();
        table_.sweep(now);
        if (metrics_) metrics_->open.Set(static_cast<double>(table_.size()));
        tell_refusals(now);
    }
}

// At most so many between two sweeps: those who came are measured, too.
void ConnectionAcceptor::accept_all() {
    for (int i = 0; i < backlog; i++) {
        sockaddr_storage peer{};
        socklen_t size = sizeof peer;
        const int descriptor = accept4(listener_, reinterpret_cast<sockaddr*>(&peer), &size,
                                       SOCK_NONBLOCK | SOCK_CLOEXEC);
        if (descriptor >= 0) {
            accept_one(descriptor, peer);
            continue;
        }
        if (errno == EMFILE || errno == ENFILE || errno == ENOMEM || errno == ENOBUFS) {
            log_warn("gRPC: cannot take a connection: {}", std::strerror(errno));
            starved_ = Clock::now().time_since_epoch().count();
            accept_again_ = Clock::now() + accept_pause;
        }
        if (errno != EINTR && errno != ECONNABORTED) return;
    }
}

void ConnectionAcceptor::accept_one(int descriptor, const sockaddr_storage& peer) {
    if (const auto why = table_.admit(descriptor, peer)) {
        refused_++;
        if (metrics_)
            metrics_
                ->refused(*why == ConnectionTable::Refusal::full ? ConnectionRefusal::limit
                                                                 : ConnectionRefusal::address_limit)
                .Increment();
        ::close(descriptor);  // the cheapest answer there is
        return;
    }
    set_option(descriptor, IPPROTO_TCP, TCP_NODELAY, 1);
    set_option(descriptor, IPPROTO_TCP, TCP_USER_TIMEOUT, silent_peer_ms);
    hand_over_(descriptor);
}

void ConnectionAcceptor::tell_refusals(Clock::time_point now) {
    if (refused_ == refused_told_ || now - told_ < tell_period) return;
    log_warn(
        "gRPC: {} connections were refused: {} are open, the most allowed in all or from one "
        "address",
        refused_ - refused_told_, table_.size());
    refused_told_ = refused_;
    told_ = now;
}

}  // namespace jostle::server
