// SPDX-License-Identifier: MIT
#include "tools/network_emulator/tcp_proxy.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace jostle::network_emulator {
namespace {

constexpr std::size_t piece_bytes = 1460;  // the segment size on Ethernet
constexpr auto longest_sleep = std::chrono::milliseconds(50);

void send_at_once(int descriptor) {
    const int on = 1;
    setsockopt(descriptor, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

bool would_block() {
    return errno == EAGAIN || errno == EINTR || errno == EINPROGRESS || errno == ENOTCONN;
}

}  // namespace

TcpProxy::~TcpProxy() {
    for (const auto& connection : connections_)
        for (const Direction& direction : connection->directions) close(direction.from);
    if (listener_ >= 0) close(listener_);
}

Status TcpProxy::listen(const std::string& address) {
    const auto target = common::resolve(settings_.target), here = common::resolve(address);
    if (!target.ok()) return target.error();
    if (!here.ok()) return here.error();
    target_ = *target;
    listener_ = socket(here->bytes.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    const int on = 1;
    setsockopt(listener_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    sockaddr_storage bound{};
    socklen_t size = sizeof bound;
    if (bind(listener_, here->get(), here->size) != 0 || ::listen(listener_, 1024) != 0 ||
        getsockname(listener_, reinterpret_cast<sockaddr*>(&bound), &size) != 0)
        return Error{ErrorCode::unavailable,
                     "cannot listen on " + address + ": " + std::strerror(errno)};
    // IPv4 and IPv6 addresses have the port at the same offset.
    port_ = ntohs(reinterpret_cast<const sockaddr_in*>(&bound)->sin_port);
    return {};
}

void TcpProxy::accept_all() {
    for (;;) {
        const int client = accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
        if (client < 0) return;
        const int server =
            socket(target_.bytes.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
        if (server < 0 ||
            (connect(server, target_.get(), target_.size) != 0 && errno != EINPROGRESS)) {
            close(client);
            if (server >= 0) close(server);
            continue;
        }
        send_at_once(client);
        send_at_once(server);
        NetworkConditions up = settings_.down;
        up.rate_kbps = 0;
        up.stall_ms = 0;
        const std::uint32_t path = 2 * accepted_++;
        connections_.push_back(std::make_unique<ProxiedConnection>(ProxiedConnection{
            .directions = {Direction{server, client, Chunks(settings_.down, path)},
                           Direction{client, server, Chunks(up, path + 1)}}}));
    }
}

void TcpProxy::read(Direction& direction, ProxiedConnection& connection,
                    Clock::time_point now) const {
    while (!direction.ended && !direction.chunks.full()) {
        std::array<char, piece_bytes> scratch;
        const ssize_t size = recv(direction.from, scratch.data(), scratch.size(), 0);
        if (size < 0 && would_block()) return;
        if (size < 0) connection.broken = true;
        if (size <= 0) {
            direction.ended = true;
            return;
        }
        direction.chunks.push(std::string(scratch.data(), static_cast<std::size_t>(size)), now);
    }
}

void TcpProxy::write_due(Direction& direction, ProxiedConnection& connection,
                         Clock::time_point now) {
    while (const std::string* chunk = direction.chunks.front(now)) {
        const ssize_t size = send(direction.to, chunk->data() + direction.written,
                                  chunk->size() - direction.written, MSG_NOSIGNAL);
        if (size < 0 && would_block()) return;
        if (size < 0) {
            connection.broken = true;
            return;
        }
        direction.written += static_cast<std::size_t>(size);
        if (direction.written < chunk->size()) return;
        direction.written = 0;
        direction.chunks.pop();
    }
    if (direction.ended && direction.chunks.empty()) shutdown(direction.to, SHUT_WR);
}

// Returns the time of the next call.
Clock::time_point TcpProxy::serve(ProxiedConnection& connection, Clock::time_point now) const {
    Clock::time_point next = now + longest_sleep;
    for (Direction& direction : connection.directions) {
        read(direction, connection, now);
        write_due(direction, connection, now);
        if (!direction.chunks.empty()) next = std::min(next, direction.chunks.next_arrival());
    }
    return next;
}

void TcpProxy::run(const std::atomic<bool>& stop) {
    Clock::time_point next = Clock::now();
    std::vector<pollfd> watched;
    while (!stop) {
        watched.assign(1, {.fd = listener_, .events = POLLIN, .revents = 0});
        for (const auto& connection : connections_)
            for (const Direction& direction : connection->directions)
                if (!direction.ended && !direction.chunks.full())
                    watched.push_back({.fd = direction.from, .events = POLLIN, .revents = 0});
        const auto wait = std::chrono::ceil<std::chrono::milliseconds>(
            std::max(Clock::duration::zero(), next - Clock::now()));
        poll(watched.data(), watched.size(), static_cast<int>(wait.count()));
        const auto now = Clock::now();
        accept_all();
        next = now + longest_sleep;
        for (const auto& connection : connections_) next = std::min(next, serve(*connection, now));
        std::erase_if(connections_, [](const auto& connection) {
            const auto& [down, up] = connection->directions;
            const bool over = connection->broken || (down.ended && down.chunks.empty() && up.ended);
            if (over)
                for (const Direction& direction : connection->directions) close(direction.from);
            return over;
        });
        next = std::max(next, now + std::chrono::milliseconds(1));
    }
}

}  // namespace jostle::network_emulator
