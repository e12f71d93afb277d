// SPDX-License-Identifier: MIT
//
// Tells a loop that a socket has something to read: a thread that waits for sockets, and puts an
// event on the loop's completion queue when there is one. gRPC's queue knows no sockets but its
// own.
#pragma once

#include <grpcpp/alarm.h>
#include <grpcpp/completion_queue.h>

#include <atomic>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

namespace jostle::client {

class SocketPoller {
public:
    // The event's tag is the watch itself.
    explicit SocketPoller(grpc::CompletionQueue& queue);
    // No event comes any more but one that is on the queue already.
    ~SocketPoller();
    SocketPoller(const SocketPoller&) = delete;
    SocketPoller& operator=(const SocketPoller&) = delete;

    // The loop's thread. A socket is told of when something new comes: read all of it. It is
    // forgotten when it is closed.
    void add(int descriptor, std::uint64_t name);
    // Whose sockets have something new; to be called at each event.
    std::vector<std::uint64_t> take_ready();

private:
    void run();

    grpc::CompletionQueue& queue_;
    int epoll_ = -1, wake_ = -1;
    grpc::Alarm alarm_;
    std::mutex mutex_;
    std::vector<std::uint64_t> ready_;
    bool event_queued_ = false;  // an event is on the queue
    std::atomic<bool> stopping_{false};
    std::thread thread_;
};

}  // namespace jostle::client
