// SPDX-License-Identifier: MIT
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/epoll.h>
#include <sys/socket.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <vector>

#include "bench/stream/minimal_server.h"

namespace jostle::bench {
namespace {

using ServerClock = std::chrono::steady_clock;

Error failed(const char* what) {
    return {ErrorCode::unavailable, std::string(what) + ": " + std::strerror(errno)};
}

class MinimalRawServer {
public:
    explicit MinimalRawServer(const MinimalServerOptions& options) : options_(options) {}
    ~MinimalRawServer() {
        for (const int client : clients_) close(client);
        if (listener_ >= 0) close(listener_);
        if (epoll_ >= 0) close(epoll_);
    }
    MinimalRawServer(const MinimalRawServer&) = delete;
    MinimalRawServer& operator=(const MinimalRawServer&) = delete;

    Status listen();
    void run(const std::atomic<bool>& stop);

private:
    void on_event(int descriptor);
    void accept_all();
    void drop(int client);
    void send_to_all();

    const MinimalServerOptions& options_;
    int listener_ = -1, epoll_ = -1;
    std::vector<int> clients_;
    std::uint32_t frame_ = 0;
};

Status MinimalRawServer::listen() {
    listener_ = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* const any = reinterpret_cast<sockaddr*>(&address);
    if (bind(listener_, any, size) != 0 || ::listen(listener_, 1024) != 0 ||
        getsockname(listener_, any, &size) != 0)
        return failed("cannot listen");
    epoll_ = epoll_create1(EPOLL_CLOEXEC);
    epoll_event event{.events = EPOLLIN, .data = {.fd = listener_}};
    epoll_ctl(epoll_, EPOLL_CTL_ADD, listener_, &event);
    return write_port_file(options_.port_file, ntohs(address.sin_port));
}

void MinimalRawServer::accept_all() {
    for (;;) {
        const int client = accept4(listener_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
        if (client < 0) return;
        const int on = 1;
        setsockopt(client, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
        epoll_event event{.events = EPOLLIN, .data = {.fd = client}};
        epoll_ctl(epoll_, EPOLL_CTL_ADD, client, &event);
        clients_.push_back(client);
    }
}

void MinimalRawServer::drop(int client) {
    close(client);
    std::erase(clients_, client);
}

// Acks are read and ignored.
void MinimalRawServer::on_event(int descriptor) {
    if (descriptor == listener_) return accept_all();
    std::array<char, 4096> scratch;
    const ssize_t size = recv(descriptor, scratch.data(), scratch.size(), 0);
    if (size == 0 || (size < 0 && errno != EAGAIN)) drop(descriptor);
}

void MinimalRawServer::send_to_all() {
    const MinimalServerMessage message = make_minimal_server_message(options_.bytes, ++frame_);
    const std::size_t size = message.head.size() + message.shared.size();
    std::string head;
    for (unsigned k = 0; k < 4; k++) head.push_back(static_cast<char>(size >> (8 * k)));
    head += message.head;
    std::array<iovec, 2> pieces{
        iovec{head.data(), head.size()},
        iovec{const_cast<char*>(message.shared.data()), message.shared.size()}};
    const msghdr message_header{.msg_iov = pieces.data(), .msg_iovlen = pieces.size()};
    const auto clients = clients_;
    // A client whose buffer is full is dropped.
    for (const int client : clients)
        if (sendmsg(client, &message_header, MSG_NOSIGNAL) !=
            static_cast<ssize_t>(head.size() + message.shared.size()))
            drop(client);
}

void MinimalRawServer::run(const std::atomic<bool>& stop) {
    const auto period = std::chrono::duration_cast<ServerClock::duration>(
        std::chrono::duration<double>(1 / options_.hz));
    auto next = ServerClock::now() + period;
    std::array<epoll_event, 256> events{};
    while (!stop) {
        const auto wait = std::chrono::ceil<std::chrono::milliseconds>(
            std::max(ServerClock::duration::zero(), next - ServerClock::now()));
        const int count = epoll_wait(epoll_, events.data(), static_cast<int>(events.size()),
                                     static_cast<int>(wait.count()));
        for (int k = 0; k < count; k++) on_event(events[static_cast<std::size_t>(k)].data.fd);
        if (ServerClock::now() < next) continue;
        send_to_all();
        next += period;
    }
}

}  // namespace

Status serve_minimal_raw(const MinimalServerOptions& options, const std::atomic<bool>& stop) {
    MinimalRawServer floor(options);
    if (Status listening = floor.listen(); !listening.ok()) return listening;
    floor.run(stop);
    return {};
}

}  // namespace jostle::bench
