// SPDX-License-Identifier: MIT
//
// One client, shared by Client (any thread) and the loop's thread.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>

#include "connection.h"
#include "conversation.h"

namespace jostle::client {

struct ClientState {
    explicit ClientState(ClientOptions options) : conversation(std::move(options)) {}

    mutable std::mutex mutex;  // guards the conversation
    Conversation conversation;
    std::atomic<bool> gone{false};  // the Client was destroyed: end the stream

    // The loop thread's own.
    std::unique_ptr<Connection> connection;
    Clock::time_point connect_at{};
    Clock::duration pause = std::chrono::milliseconds(250);
    bool over = false;
};

}  // namespace jostle::client
