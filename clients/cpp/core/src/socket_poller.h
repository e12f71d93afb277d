// SPDX-License-Identifier: MIT
//
// Notifies a loop when a socket becomes readable: a thread waits for the sockets and posts an event
// to the loop's completion queue, because gRPC's queue supports only its own sockets.
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
    // The tag of the event is the poller itself.
    explicit SocketPoller(grpc::CompletionQueue& queue);
    // After the destructor no event is posted; one may still be in the queue.
    ~SocketPoller();
    SocketPoller(const SocketPoller&) = delete;
    SocketPoller& operator=(const SocketPoller&) = delete;

    // Called by the loop's thread. The poller reports a socket when new data arrives, so the caller
    // must read all of it. Closing the socket removes it.
    void add(int descriptor, std::uint64_t name);
    // Returns the ids of sockets with new data; to be called for each event.
    std::vector<std::uint64_t> take_ready();

private:
    void run();

    grpc::CompletionQueue& queue_;
    int epoll_ = -1, wake_ = -1;
    grpc::Alarm alarm_;
    std::mutex mutex_;
    std::vector<std::uint64_t> ready_;
    bool event_queued_ = false;  // an event is in the queue
    std::atomic<bool> stopping_{false};
    std::thread thread_;
};

}  // namespace jostle::client
