// SPDX-License-Identifier: MIT
//
// What one message of a stream costs a server. The processor time of the whole process with many
// clients, less that with one client: so physics, encoding and whatever else does not grow with the
// clients is not in it.
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
    int bytes = 1000;                          // of a message, of floors
    std::string scene;                         // of jostle-server, a file
};

// Who sends, and how. The order is that of the table: each kind after the floor it is compared
// with.
enum class StreamKind { raw, grpc_minimal, grpc, websocket_minimal, websocket };
const char* name_of(StreamKind kind);
// Its floor: what its cost is divided by.
std::optional<StreamKind> minimal_server_of(StreamKind kind);

struct StreamCost {
    double us_per_message = 0;         // of a snapshot: of what else was sent, its share
    double single_client_percent = 0;  // of a core, with one client
    double total_percent = 0;          // with all
    double snapshots_per_second = 0, messages_per_second = 0;  // of a client
    double snapshot_bytes = 0;
    double age_ms_p50 = 0, age_ms_p99 = 0;  // 0: of floors, which tell no time
    double memory_kb_per_client = 0;        // of the server's process
    double client_us_per_message = 0;
};

Result<StreamCost> measure_stream(StreamKind kind, const StreamRequest& request);

// A scene of bodies that only turn: cheap to step, and all of them are in each snapshot.
Status write_turning_scene(const std::string& path, int bodies);

nlohmann::ordered_json to_json(const StreamCost& cost);

}  // namespace jostle::bench
