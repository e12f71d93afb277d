// SPDX-License-Identifier: MIT
//
// The cost of one message of a stream: the CPU time of the server process with many clients minus
// that with one client. Physics, encoding and other work that does not grow with the clients is
// therefore not included.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "jostle/base/result.h"
#include "tools/load/load_options.h"

namespace jostle::bench {

struct StreamRequest {
    int clients = 100;
    double seconds = 5;
    int ack_every = 6;
    std::vector<std::string> server_settings;  // KEY=VALUE for jostle-server
    int bytes = 1000;                          // of a message, for minimal servers
    std::string scene;                         // of jostle-server, a file
};

// Server and transport, in the order of the table: each kind follows the minimal server that it is
// compared with.
enum class StreamKind { raw, grpc_minimal, grpc, websocket_minimal, websocket };
const char* name_of(StreamKind kind);
// The minimal server that the kind is compared with; nothing for minimal servers.
std::optional<StreamKind> minimal_server_of(StreamKind kind);

struct StreamCost {
    double us_per_message = 0;         // per snapshot, including a share of the other messages
    double single_client_percent = 0;  // of one core, with one client
    double total_percent = 0;          // of one core, with all clients
    double snapshots_per_second = 0, messages_per_second = 0;  // per client
    double snapshot_bytes = 0;
    double age_ms_p50 = 0, age_ms_p99 = 0;  // 0 for minimal servers, which send no time
    double memory_kb_per_client = 0;        // of the server process
    double client_us_per_message = 0;
};

Result<StreamCost> measure_stream(StreamKind kind, const StreamRequest& request);

// Writes a scene of rotating bodies: cheap to step, and every snapshot contains all of them.
Status write_turning_scene(const std::string& path, int bodies);

nlohmann::ordered_json to_json(const StreamCost& cost);

}  // namespace jostle::bench
