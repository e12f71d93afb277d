// SPDX-License-Identifier: MIT
#include "clients/cpp/core/src/socket_poller.h"

#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <array>
#include <utility>

namespace jostle::client {

SocketPoller::SocketPoller(grpc::CompletionQueue& queue)
    : queue_(queue), epoll_(epoll_create1(EPOLL_CLOEXEC)), wake_(eventfd(0, EFD_CLOEXEC)) {
    epoll_event event{.events = EPOLLIN, .data = {.u64 = 0}};
    epoll_ctl(epoll_, EPOLL_CTL_ADD, wake_, &event);
    thread_ = std::thread([this] { run(); });
}

SocketPoller::~SocketPoller() {
    stopping_ = true;
    eventfd_write(wake_, 1);
    thread_.join();
    close(wake_);
    close(epoll_);
}

void SocketPoller::add(int descriptor, std::uint64_t name) {
    epoll_event event{.events = EPOLLIN | EPOLLET, .data = {.u64 = name}};
    epoll_ctl(epoll_, EPOLL_CTL_ADD, descriptor, &event);
}

std::vector<std::uint64_t> SocketPoller::take_ready() {
    const std::lock_guard lock(mutex_);
    event_queued_ = false;
    return std::exchange(ready_, {});
}

void SocketPoller::run() {
    std::array<epoll_event, 64> events;
    while (!stopping_) {
        const int count = epoll_wait(epoll_, events.data(), static_cast<int>(events.size()), -1);
        const std::lock_guard lock(mutex_);
        for (int k = 0; k < count; k++)
            if (const auto name = events[static_cast<std::size_t>(k)].data.u64; name != 0)
                ready_.push_back(name);
        if (stopping_ || ready_.empty() || std::exchange(event_queued_, true)) continue;
        alarm_.Set(&queue_, gpr_now(GPR_CLOCK_MONOTONIC), this);
    }
}

}  // namespace jostle::client
