// SPDX-License-Identifier: MIT
#include "server/grpc_proxy/connection_acceptor.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "jostle/base/check.h"
#include "server/util/address.h"
#include "server/util/log.h"
#include "server/util/socket.h"
#include "server/util/wrong_protocol.h"

namespace jostle::server {

namespace {

constexpr int poll_period_ms = 50, idle_poll_period_ms = 250;
constexpr int niceness = 5;
constexpr auto handshake_max = std::chrono::seconds(5);
constexpr int backlog = 1024;
constexpr auto log_period = std::chrono::seconds(5);
// If no descriptor is available, an immediate retry would only spin.
constexpr auto accept_pause = std::chrono::milliseconds(100);

ConnectionRefusal reason_of(ConnectionTable::Refusal refusal) {
    using enum ConnectionTable::Refusal;
    return refusal == full           ? ConnectionRefusal::limit
           : refusal == address_full ? ConnectionRefusal::address_limit
                                     : ConnectionRefusal::penalty;
}

}  // namespace

ConnectionAcceptor::~ConnectionAcceptor() {
    stop();
    if (wake_ >= 0) ::close(wake_);
    if (epoll_ >= 0) ::close(epoll_);
}

Status ConnectionAcceptor::listen(const std::string& host, std::uint16_t port) {
    const auto failed = [&](const std::string& refusal) {
        return Error{ErrorCode::unavailable,
                     fmt::format("cannot listen on {}:{} for gRPC: {}; choose another with "
                                 "--listen HOST:PORT",
                                 host, port, refusal)};
    };
    const Result<int> bound = open_bound_socket(host, port, SOCK_STREAM);
    if (!bound.ok()) return failed(bound.error().message);
    listener_ = *bound;
    if (::listen(listener_, backlog) != 0) {
        const int error = errno;
        ::close(std::exchange(listener_, -1));
        return failed(std::strerror(error));
    }
    wake_ = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
    epoll_ = epoll_create1(EPOLL_CLOEXEC);
    if (wake_ < 0 || epoll_ < 0) return failed(std::strerror(errno));
    set_epoll_events(wake_, EPOLLIN, EPOLL_CTL_ADD);
    set_epoll_events(listener_, EPOLLIN, EPOLL_CTL_ADD);
    port_ = port_of(listener_);
    ASSERT(port_ != 0);
    return {};
}

void ConnectionAcceptor::start(Handler handler) {
    ASSERT(listener_ >= 0 && !thread_.joinable());
    handler_ = std::move(handler);
    thread_ = std::thread([this] { run(); });
}

void ConnectionAcceptor::stop() {
    stopping_ = true;
    if (wake_ >= 0) eventfd_write(wake_, 1);
    if (thread_.joinable()) thread_.join();
    if (listener_ >= 0) ::close(std::exchange(listener_, -1));
}

bool ConnectionAcceptor::is_listening(Clock::time_point now) const {
    const auto since = [&](Clock::rep at) { return now - Clock::time_point(Clock::duration(at)); };
    return since(polled_at_) < std::chrono::seconds(1) && since(failed_at_) > 2 * accept_pause;
}

void ConnectionAcceptor::set_epoll_events(int descriptor, std::uint32_t events, int how) const {
    ASSERT(epoll_ >= 0 && descriptor >= 0);
    epoll_event event{.events = events, .data = {.fd = descriptor}};
    epoll_ctl(epoll_, how, descriptor, &event);
}

void ConnectionAcceptor::run() {
    ClientSocket::block_broken_pipe_signal();
    setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), niceness);
    std::array<epoll_event, 64> events;
    while (!stopping_) {
        const bool is_idle = pending_handshakes_.empty() && Clock::now() >= accept_again_;
        const int count = epoll_wait(epoll_, events.data(), static_cast<int>(events.size()),
                                     is_idle ? idle_poll_period_ms : poll_period_ms);
        const Clock::time_point now = Clock::now();
        polled_at_ = now.time_since_epoch().count();
        for (int i = 0; i < count; i++) {
            const int descriptor = events[static_cast<std::size_t>(i)].data.fd;
            try {
                if (descriptor == listener_)
                    accept_all(now);
                else if (descriptor != wake_)
                    continue_handshake(descriptor, now);
            } catch (const std::exception& error) {
                // Out of memory: this connection is rejected.
                log_error("gRPC: a connection failed: {}", error.what());
            }
        }
        // Without available descriptors the listener would stay readable and the loop would spin.
        set_epoll_events(listener_, now < accept_again_ ? 0u : EPOLLIN, EPOLL_CTL_MOD);
        drop_timed_out(now);
        if (metrics_) metrics_->open.Set(static_cast<double>(table_.size()));
        log_refusals(now);
    }
    for (auto& [descriptor, pending] : pending_handshakes_) table_.remove(*pending.connection);
    pending_handshakes_.clear();
}

// A bounded number per round, so that pending handshakes also make progress.
void ConnectionAcceptor::accept_all(Clock::time_point now) {
    for (int i = 0; i < backlog; i++) {
        sockaddr_storage peer{};
        socklen_t size = sizeof peer;
        const int descriptor = accept4(listener_, reinterpret_cast<sockaddr*>(&peer), &size,
                                       SOCK_NONBLOCK | SOCK_CLOEXEC);
        if (descriptor >= 0) {
            accept_one(descriptor, peer, now);
            continue;
        }
        if (errno == EMFILE || errno == ENFILE || errno == ENOMEM || errno == ENOBUFS) {
            log_warn("gRPC: cannot accept a connection: {}", std::strerror(errno));
            failed_at_ = now.time_since_epoch().count();
            accept_again_ = now + accept_pause;
        }
        if (errno != EINTR && errno != ECONNABORTED) return;
    }
}

void ConnectionAcceptor::accept_one(int descriptor, const sockaddr_storage& peer,
                                    Clock::time_point now) {
    if (const auto refusal = table_.refusal_for(peer, now)) {
        count(*refusal);
        ::close(descriptor);  // the cheapest refusal
        return;
    }
    set_socket_option(descriptor, IPPROTO_TCP, TCP_NODELAY, 1);
    set_tcp_user_timeout(descriptor, tcp_user_timeout_);
    const auto tls = tls_.current();
    auto socket = std::make_unique<ClientSocket>(descriptor, tls ? tls->native_handle() : nullptr);
    const std::shared_ptr<Connection> connection = table_.admit(peer);
    const bool has_proxy_header = proxy_protocol_ && table_.is_proxy(peer);
    if (!tls && !has_proxy_header) return hand_off(std::move(socket), connection);
    ASSERT(!pending_handshakes_.contains(descriptor));
    PendingHandshake& pending =
        pending_handshakes_[descriptor] = {std::move(socket), connection, now + handshake_max};
    if (has_proxy_header) pending.proxy_header.emplace();
    set_epoll_events(descriptor, EPOLLIN, EPOLL_CTL_ADD);
}

void ConnectionAcceptor::count(ConnectionTable::Refusal refusal) {
    refused_++;
    if (metrics_) metrics_->refused(reason_of(refusal)).Increment();
}

// A step of a pending handshake: the PROXY header, then TLS.
void ConnectionAcceptor::continue_handshake(int descriptor, Clock::time_point now) {
    const auto at = pending_handshakes_.find(descriptor);
    if (at == pending_handshakes_.end()) return;
    Progress progress = Progress::done;
    if (at->second.proxy_header) progress = read_proxy_header(at->second, now);
    if (progress == Progress::done) progress = continue_tls(at->second);
    if (progress == Progress::waits) return;
    set_epoll_events(descriptor, 0, EPOLL_CTL_DEL);
    PendingHandshake pending = std::move(at->second);
    pending_handshakes_.erase(at);
    if (progress == Progress::done) hand_off(std::move(pending.socket), pending.connection);
}

// Reads no byte behind the header: TLS reads from the socket itself.
ConnectionAcceptor::Progress ConnectionAcceptor::read_proxy_header(PendingHandshake& pending,
                                                                   Clock::time_point now) {
    ProxyHeaderReader& header = *pending.proxy_header;
    std::array<std::uint8_t, 512> buffer;
    while (header.wanted() > 0) {
        const ssize_t count = ::recv(pending.socket->descriptor(), buffer.data(),
                                     std::min(buffer.size(), header.wanted()), 0);
        if (count < 0 && (errno == EAGAIN || errno == EINTR)) return Progress::waits;
        const Status taken =
            count > 0 ? header.take({buffer.data(), static_cast<std::size_t>(count)})
                      : Status(invalid_argument("the connection was closed in the PROXY header"));
        if (taken.ok()) continue;
        reject(pending, ConnectionRefusal::proxy_header, taken.error().message);
        return Progress::failed;
    }
    if (const auto client = header.client())
        if (const auto refusal = table_.set_client(*pending.connection, *client, now)) {
            refused_++;
            reject(pending, reason_of(*refusal),
                   "its client " + peer_name(*client) + " is refused");
            return Progress::failed;
        }
    pending.proxy_header.reset();
    return Progress::done;
}

ConnectionAcceptor::Progress ConnectionAcceptor::continue_tls(PendingHandshake& pending) {
    ClientSocket& socket = *pending.socket;
    if (socket.has_tls() && !pending.has_first_bytes) {
        std::array<std::uint8_t, 16> first;
        const ssize_t count = ::recv(socket.descriptor(), first.data(), first.size(), MSG_PEEK);
        if (count < 0 && (errno == EAGAIN || errno == EINTR)) return Progress::waits;
        pending.has_first_bytes = true;
        const auto protocol =
            protocol_of({first.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0))});
        if (protocol == FirstBytes::http1 || protocol == FirstBytes::http2) {
            socket.reply_unencrypted(wrong_protocol_reply(
                protocol, "this gRPC port requires TLS: use https:// or TLS credentials"));
            reject(pending, ConnectionRefusal::handshake, "the client does not use TLS");
            return Progress::failed;
        }
    }
    const ClientSocket::State state = socket.handshake();
    if (state == ClientSocket::State::wants_read || state == ClientSocket::State::wants_write) {
        set_epoll_events(socket.descriptor(),
                         state == ClientSocket::State::wants_read ? EPOLLIN : EPOLLOUT,
                         EPOLL_CTL_MOD);
        return Progress::waits;
    }
    if (state != ClientSocket::State::open) {
        reject(pending, ConnectionRefusal::handshake, "TLS handshake failed: " + socket.failure());
        return Progress::failed;
    }
    pending.connection->certificate = socket.certificate();
    return Progress::done;
}

void ConnectionAcceptor::hand_off(std::unique_ptr<ClientSocket> socket,
                                  const std::shared_ptr<Connection>& connection) {
    try {
        ASSERT(socket && connection);
        handler_(std::move(socket), connection);
    } catch (...) {
        table_.remove(*connection);
        throw;
    }
}

void ConnectionAcceptor::reject(PendingHandshake& pending, ConnectionRefusal refusal,
                                const std::string& why) {
    // A wrong header is a mistake of the operator, not of a stranger.
    if (refusal == ConnectionRefusal::proxy_header)
        log_warn("{}: connection closed: {}", pending.connection->peer, why);
    else
        log_debug("{}: connection closed: {}", pending.connection->peer, why);
    if (metrics_) metrics_->refused(refusal).Increment();
    table_.remove(*pending.connection);
}

void ConnectionAcceptor::drop_timed_out(Clock::time_point now) {
    for (auto at = pending_handshakes_.begin(); at != pending_handshakes_.end();) {
        if (now < at->second.deadline) {
            ++at;
            continue;
        }
        reject(at->second,
               at->second.proxy_header ? ConnectionRefusal::proxy_header
                                       : ConnectionRefusal::handshake,
               "the handshake timed out");
        at = pending_handshakes_.erase(at);
    }
}

void ConnectionAcceptor::log_refusals(Clock::time_point now) {
    ASSERT(refused_ >= refused_logged_);
    if (refused_ == refused_logged_ || now - logged_at_ < log_period) return;
    log_warn(
        "gRPC: refused {} connections: {} are open, a limit in total or per address is reached, or "
        "their addresses are blocked after an attack",
        refused_ - refused_logged_, table_.size());
    refused_logged_ = refused_;
    logged_at_ = now;
}

}  // namespace jostle::server
