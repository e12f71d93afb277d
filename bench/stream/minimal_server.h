// SPDX-License-Identifier: MIT
//
// Minimal servers: they send the same bytes to all clients at a constant rate and do nothing else.
// Their cost is the lower bound for a stream over a transport, with which jostle-server is
// compared. Each runs in its own process with one thread for all clients, so that the CPU time of
// the process is the cost. Loopback only.
#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "jostle/base/result.h"

namespace jostle::bench {

struct MinimalServerOptions {
    int bytes = 1000;       // of the shared part of a message
    double hz = 60;         // messages per second to each client
    std::string port_file;  // the port is written to it, in the format of jostle-server
};

// Length-prefixed messages over plain sockets.
Status serve_minimal_raw(const MinimalServerOptions& options, const std::atomic<bool>& stop);
// gRPC: one completion queue with a deadline as the tick, raw byte buffers, the shared part as a
// shared slice.
Status serve_minimal_grpc(const MinimalServerOptions& options, const std::atomic<bool>& stop);
// WebSocket: Beast, the shared part in a buffer sequence.
Status serve_minimal_websocket(const MinimalServerOptions& options, const std::atomic<bool>& stop);

// The two parts of one message, as in jostle-server: the part for one client precedes the shared
// part; together they are a ServerMessage with a snapshot.
struct MinimalServerMessage {
    std::string head, shared;
};
MinimalServerMessage make_minimal_server_message(int bytes, std::uint32_t frame);

// Writes a temporary file and renames it, so that readers see the complete file.
Status write_port_file(const std::string& port_file, int port);

}  // namespace jostle::bench
