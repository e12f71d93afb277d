// SPDX-License-Identifier: MIT
//
// Every setting of the server in one struct, with its unit, its default and its reason. Filled from
// defaults, then the TOML file (config_loader.h), then flags; checked once at start.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "jostle/base/result.h"

namespace jostle::server {

// What one client may do. The defaults let a person play hard and stop a script that floods.
struct ClientLimits {
    double messages_per_second = 90;  // ClientMessages, beside one Ack per snapshot
    double bytes_per_second = 65536;
    double inputs_per_second = 300;
    int message_bytes_max = 65536;
    int inputs_per_batch_max = 64;
    int bodies_owned_max = 50;
    bool keep_bodies_after_leave = false;  // else what a client spawned goes with it
};

struct WorldLimits {
    int worlds_max = 64;
    int bodies_max = 20000;        // per world
    int clients_max = 1000;        // per server
    int command_queue_max = 8192;  // commands waiting for a tick; full: the input is refused
};

struct TickSettings {
    // When late, up to this many ticks run at once to catch up; what is later than that is skipped
    // and counted as late, so that a stall of the machine is not followed by a burst.
    int catch_up_max = 4;
    int physics_threads = 1;  // per world
};

struct StreamSettings {
    int ack_window_min = 4;  // snapshots in flight
    int ack_window_max = 30;
    double hello_seconds = 5;     // a stream that says nothing is closed
    double silence_seconds = 10;  // a client that says nothing at all is gone
    double stats_per_second = 10;
};

struct Config {
    std::string listen = "127.0.0.1:50051";  // gRPC
    std::string http = "127.0.0.1:8080";     // viewer, WebSocket, health
    std::string admin = "127.0.0.1:9464";    // metrics, health, profiles; empty: nothing listens
    std::string web_root = "clients/web/dist";
    std::vector<std::string> scenes = {"sandbox"};  // one world each: catalogue names or files
    std::vector<std::string> allowed_origins;       // pages from elsewhere that may use this server
    std::string log_level = "info";                 // trace, debug, info, warn, error
    double drain_seconds = 5;                       // after SIGTERM, for clients to leave
    int network_threads = 1;                        // gRPC play streams; each owns its clients
    ClientLimits client;
    WorldLimits world;
    TickSettings tick;
    StreamSettings stream;
};

// Errors name the key and its range.
Status check(const Config& config);

struct HostPort {
    std::string host;
    std::uint16_t port = 0;
};
// "127.0.0.1:8080", "[::1]:8080" or "localhost:0" (0: any free port).
Result<HostPort> parse_host_port(const std::string& text);

}  // namespace jostle::server
