// SPDX-License-Identifier: MIT
//
// State of one client, shared by Client (any thread) and the loop's thread.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "clients/cpp/core/src/connection.h"
#include "clients/cpp/core/src/datagram_socket.h"
#include "clients/cpp/core/src/play_protocol.h"
#include "jostle/base/network_queue.h"

namespace jostle::client {

struct ClientState {
    explicit ClientState(ClientOptions options) : protocol(std::move(options)) {}

    mutable std::mutex mutex;  // guards the protocol
    PlayProtocol protocol;
    std::atomic<bool> destroyed{false};  // the Client was destroyed: close the stream

    // Used by the loop's thread only.
    std::unique_ptr<Connection> connection;
    std::unique_ptr<DatagramSocket> datagrams;  // of the connection's stream; null: none
    std::uint64_t socket_id = 0;                // for the socket poller
    // With simulated network conditions: messages in transit. Empty otherwise.
    std::optional<NetworkQueue<std::string>> incoming, outgoing;
    Clock::time_point connect_at{};
    Clock::duration reconnect_delay = std::chrono::milliseconds(250);
    std::optional<Clock::time_point> disconnect_deadline;  // of a destroyed client
    bool finished = false;
};

}  // namespace jostle::client
