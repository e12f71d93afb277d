// SPDX-License-Identifier: MIT
#include "tools/load/passive_client.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/epoll.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "tools/load/framing.h"
#include "tools/load/http2_framing.h"
#include "tools/load/websocket_framing.h"

namespace jostle::load {
namespace {

// Bytes that a slow WebSocket reader reads from the socket at once, so that TCP flow control slows
// down the server.
constexpr std::size_t slow_read_bytes = 2048;

std::unique_ptr<Framing> make_framing(const LoadOptions& plan) {
    switch (plan.transport) {
        case Transport::websocket:
            return std::make_unique<WebSocketFraming>(plan.target);
        case Transport::raw:
            return std::make_unique<RawFraming>();
        case Transport::grpc:
            break;
    }
    // A slow reader uses the default window. Other clients use a window that never fills, so that
    // the work of the server is the same in each run.
    return std::make_unique<Http2Framing>(Http2Request{
        .authority = plan.target,
        .token = plan.security.token,
        .window = plan.read_rate > 0 ? Http2Request::default_window : Http2Request::window_max});
}

}  // namespace

PassiveClient::PassiveClient(const LoadOptions& plan, PassiveClientOptions options, int epoll,
                             LoadMetrics& metrics)
    : plan_(plan),
      epoll_(epoll),
      metrics_(metrics),
      protocol_(std::move(options), metrics),
      framing_(make_framing(plan)) {}

PassiveClient::~PassiveClient() {
    if (socket_ >= 0) close(socket_);
}

void PassiveClient::connect(const common::SocketAddress& address) {
    socket_ = socket(address.bytes.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (socket_ < 0) return end(std::string("cannot create a socket: ") + std::strerror(errno));
    const int on = 1;
    setsockopt(socket_, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    if (::connect(socket_, address.get(), address.size) != 0 && errno != EINPROGRESS)
        return end(std::string("cannot connect: ") + std::strerror(errno));
    epoll_events_ = EPOLLIN | EPOLLOUT;
    epoll_event event{.events = epoll_events_, .data = {.ptr = this}};
    if (epoll_ctl(epoll_, EPOLL_CTL_ADD, socket_, &event) != 0)
        end(std::string("cannot add a socket to epoll: ") + std::strerror(errno));
}

void PassiveClient::on_event(std::span<std::uint8_t> scratch, Clock::time_point now) {
    if (closed_) return;
    now_ = now;
    if (!is_backpressured()) receive(scratch);
    tick(now);
}

void PassiveClient::tick(Clock::time_point now) {
    if (closed_ || socket_ < 0) return;
    read_waiting(now);
    protocol_.render(now);
    send_due(now);
    flush();
    if (!closed_) update_epoll();
}

std::string PassiveClient::why_closed() const {
    std::string reason = "the server closed the connection";
    if (protocol_.joined()) return reason;
    reason += " before its Welcome; check that --server is the port of ";
    reason += plan_.transport == Transport::websocket ? "HTTP" : "gRPC";
    return reason;
}

void PassiveClient::receive(std::span<std::uint8_t> scratch) {
    if (plan_.read_rate > 0 && plan_.transport != Transport::grpc)
        scratch = scratch.first(slow_read_bytes);
    const ssize_t size = recv(socket_, scratch.data(), scratch.size(), 0);
    if (size < 0 && (errno == EAGAIN || errno == EINTR)) return;
    if (size <= 0) return end(size < 0 ? std::strerror(errno) : why_closed());
    const Status taken = framing_->take(scratch.first(static_cast<std::size_t>(size)), *this);
    if (!taken.ok()) end(taken.error().message);
}

void PassiveClient::on_message(Bytes message) {
    if (plan_.read_rate > 0) {
        waiting_.emplace_back(reinterpret_cast<const char*>(message.data()), message.size());
        return;
    }
    protocol_.receive(message, now_);
    framing_->consume(message.size());
}

void PassiveClient::read_waiting(Clock::time_point now) {
    while (!waiting_.empty() && now >= next_read_) {
        const auto period = std::chrono::duration_cast<Clock::duration>(
            std::chrono::duration<double>(1 / protocol_.options().read_rate));
        // A pause does not allow faster reading afterwards.
        next_read_ = (now - next_read_ < period ? next_read_ : now) + period;
        const std::string message = std::move(waiting_.front());
        waiting_.pop_front();
        protocol_.receive({reinterpret_cast<const std::uint8_t*>(message.data()), message.size()},
                          now);
        framing_->consume(message.size());
    }
}

void PassiveClient::send_due(Clock::time_point now) {
    while (const auto message = protocol_.take_message(now)) framing_->send(*message);
}

void PassiveClient::flush() {
    std::string& out = framing_->outgoing();
    if (out.empty()) return;
    const ssize_t sent = ::send(socket_, out.data(), out.size(), MSG_NOSIGNAL);
    if (sent > 0) out.erase(0, static_cast<std::size_t>(sent));
    if (sent < 0 && errno != EAGAIN && errno != EINTR && errno != ENOTCONN)
        end(std::string("cannot send: ") + std::strerror(errno));
}

// gRPC reads ahead up to its window; a WebSocket reader reads from the transport directly.
bool PassiveClient::is_backpressured() const {
    return plan_.transport != Transport::grpc && !waiting_.empty();
}

void PassiveClient::update_epoll() {
    const std::uint32_t wanted =
        (is_backpressured() ? 0u : EPOLLIN) | (framing_->outgoing().empty() ? 0u : EPOLLOUT);
    if (wanted == epoll_events_) return;
    epoll_events_ = wanted;
    epoll_event event{.events = wanted, .data = {.ptr = this}};
    epoll_ctl(epoll_, EPOLL_CTL_MOD, socket_, &event);
}

void PassiveClient::end(const std::string& reason) {
    closed_ = true;
    metrics_.add_error(protocol_.notice().empty() ? reason : reason + ": " + protocol_.notice());
    if (socket_ >= 0) close(socket_);
    socket_ = -1;
}

}  // namespace jostle::load
