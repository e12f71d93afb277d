// SPDX-License-Identifier: MIT
//
// The inside of Loop and Client, shared by loop.cpp and client.cpp.
#pragma once

#include <grpcpp/completion_queue.h>

#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

#include "connection.h"
#include "conversation.h"

namespace jostle::client {

struct Client::Impl {
    explicit Impl(ClientOptions options) : conversation(std::move(options)) {}

    mutable std::mutex mutex;  // guards the conversation
    Conversation conversation;
    std::atomic<bool> gone{false};  // the Client was destroyed: end the stream

    // The loop thread's own.
    std::unique_ptr<Connection> connection;
    Clock::time_point connect_at{};
    Clock::duration pause = std::chrono::milliseconds(250);
    bool over = false;
};

struct Loop::Impl {
    Impl();
    void stop();
    void add(std::shared_ptr<Client::Impl> client);

    void run();
    void take_new_clients();
    void advance(Client::Impl& client, Clock::time_point now);
    void handle(const Connection::Tag& tag, bool ok, Clock::time_point now);
    void after_end(Client::Impl& client, Clock::time_point now);
    void drain();

    grpc::CompletionQueue queue;
    std::mutex mutex;  // guards `fresh`
    std::vector<std::shared_ptr<Client::Impl>> fresh;
    std::vector<std::shared_ptr<Client::Impl>> clients;  // the loop thread's own
    std::atomic<bool> stopping{false};
    std::thread thread;
};

}  // namespace jostle::client
