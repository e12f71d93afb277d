// SPDX-License-Identifier: MIT
//
// The thread of a Loop: a completion queue and the clients whose connections it serves.
#pragma once

#include <grpcpp/completion_queue.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <thread>
#include <unordered_map>
#include <vector>

#include "clients/cpp/core/src/client_state.h"
#include "clients/cpp/core/src/socket_poller.h"

namespace jostle::client {

class LoopThread {
public:
    LoopThread();
    ~LoopThread();  // closes all connections
    // Any thread.
    void add(std::shared_ptr<ClientState> client);

private:
    void run();
    void take_new_clients();
    void advance(ClientState& client, Clock::time_point now);
    void receive(ClientState& client, Clock::time_point now);
    void write(ClientState& client, Clock::time_point now);
    void open_datagrams(ClientState& client, Clock::time_point now);
    void read_datagrams(ClientState& client, Clock::time_point now);
    void send_datagrams(ClientState& client, Clock::time_point now);
    void read_ready(Clock::time_point now);
    Clock::duration housekeeping_period() const;
    void handle(const Connection::Tag& tag, bool ok, Clock::time_point now);
    void disconnect(ClientState& client, Clock::time_point now);
    void on_stream_end(ClientState& client, Clock::time_point now);
    void drain();

    grpc::CompletionQueue queue_;
    std::mutex mutex_;  // guards new_clients_
    std::vector<std::shared_ptr<ClientState>> new_clients_;
    std::vector<std::shared_ptr<ClientState>> clients_;  // used by the thread only
    std::unique_ptr<SocketPoller> poller_;  // created for the first client with datagrams
    std::uint64_t next_socket_id_ = 0;
    std::unordered_map<std::uint64_t, ClientState*> clients_by_socket_;  // by socket id
    std::atomic<bool> stopping_{false};
    std::thread thread_;
};

}  // namespace jostle::client
