// SPDX-License-Identifier: MIT
//
// One client, shared by Client (any thread) and the loop's thread.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>

#include "clients/cpp/core/src/connection.h"
#include "clients/cpp/core/src/datagram_socket.h"
#include "clients/cpp/core/src/delayed_messages.h"
#include "clients/cpp/core/src/play_protocol.h"

namespace jostle::client {

struct ClientState {
    explicit ClientState(ClientOptions options) : protocol(std::move(options)) {}

    mutable std::mutex mutex;  // guards the conversation
    PlayProtocol protocol;
    std::atomic<bool> destroyed{false};  // the Client was destroyed: end the stream

    // The loop thread's own.
    std::unique_ptr<Connection> connection;
    std::unique_ptr<DatagramSocket> datagrams;  // of the connection's stream, if it has any
    std::uint64_t socket_id = 0;                // for the watch
    // Of a client with a bad link: what is on its way in and out. Empty otherwise.
    std::optional<DelayedMessages> incoming, outgoing;
    Clock::time_point connect_at{};
    Clock::duration reconnect_delay = std::chrono::milliseconds(250);
    std::optional<Clock::time_point> disconnect_deadline;  // of a client that is gone
    bool finished = false;
};

}  // namespace jostle::client
