// SPDX-License-Identifier: MIT
//
// Servers that do nothing but send the same bytes to all who connect, at a steady rate: the least
// that a stream costs over a transport, to compare jostle-server with. Each runs in a process of
// its own, one thread for all its clients, so that its processor time is what it costs. Loopback
// only.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "jostle/base/result.h"

namespace jostle::bench {

struct MinimalServerOptions {
    int bytes = 1000;       // of a message: the part that all clients share
    double hz = 60;         // messages a second to each client
    std::string port_file;  // is told the port, as jostle-server tells its own
};

// Messages with their length, over bare sockets.
Status serve_minimal_raw(const MinimalServerOptions& options, const std::atomic<bool>& stop);
// gRPC: a completion queue that ticks itself, raw byte buffers, the shared part a shared slice.
Status serve_minimal_grpc(const MinimalServerOptions& options, const std::atomic<bool>& stop);
// WebSocket: Beast, the shared part in a buffer sequence.
Status serve_minimal_websocket(const MinimalServerOptions& options, const std::atomic<bool>& stop);

// The two parts of one message, as ours are: what a client has for itself goes first, and together
// they are a ServerMessage with a snapshot.
struct MinimalServerMessage {
    std::string head, shared;
};
MinimalServerMessage make_minimal_server_message(int bytes, std::uint32_t frame);

// Written beside the file and renamed: who waits for it reads all of it.
Status write_port_file(const std::string& port_file, int port);

}  // namespace jostle::bench
