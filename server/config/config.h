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
    bool retain_bodies_after_leave = false;  // else what a client spawned goes with it
    // How long the place of a client is kept whose connection broke, if it said that it would come
    // back; 0: not at all.
    double resume_timeout_seconds = 30;
};

struct WorldLimits {
    int worlds_max = 64;
    int bodies_max = 20000;             // per world
    int bodies_total_max = 50000;       // of all worlds: some 5 kB each
    int clients_max = 1000;             // per server
    int clients_per_address_max = 250;  // of one IPv4 address or IPv6 /64
    int command_queue_max = 8192;       // commands waiting for a tick; full: the input is refused
};

// What a scene may cost that is to be hosted (host/scene_budget.h says what each bounds).
struct SceneLimits {
    int joints_max = 20000;
    int joints_per_pair_max = 64;
    double geometry_bytes_max = 32e6;
    int body_geometry_bytes_max = 65536;
    double work_per_second_max = 2e8;
    double work_total_per_second_max = 4e8;  // of all worlds together
    double first_step_seconds_max = 0.5;
};

struct TickSettings {
    // When late, up to this many ticks run at once to catch up; what is later than that is skipped
    // and counted as late, so that a stall of the machine is not followed by a burst.
    int catch_up_ticks_max = 4;
    int physics_threads = 1;  // per world
    // A step that takes longer is interrupted and its world paused, so that it holds up nobody
    // else.
    double step_seconds_max = 1;
    // How long ago a client may have seen what it asks about or aims at: its delay both ways and
    // that of its pictures. So long frames are kept.
    double lag_compensation_ms_max = 400;
};

struct StreamSettings {
    int ack_window_max = 30;             // messages on the way to a client
    int ack_interval_ms = 100;           // how often a client acknowledges
    double hello_timeout_seconds = 5;    // a stream that says nothing is closed
    double client_timeout_seconds = 10;  // a client that says nothing at all is gone
    double stats_per_second = 2;
    int codec = 2;  // of snapshots: the highest that clients are offered
    double interest_cell_m =
        32;  // edge of the parts of a world that clients with an interest are told of
    // Snapshots a second to a client while nothing in its world moves.
    double heartbeats_per_second = 4;
};

// Certificates of both listeners, PEM; read again when they change.
struct TlsSettings {
    std::string certificate;  // the server's own, then what links it to its root
    std::string key;          // without a passphrase
    std::string client_ca;    // who shows a certificate of it is an admin

    bool operator==(const TlsSettings&) const = default;
};

// Whose tokens are believed, and what those may do who show none (docs/security.md).
struct AuthSettings {
    std::string issuer, audience;  // "iss" and "aud" of every token
    std::string keys;              // JWKS file; empty: no token is believed
    std::string anonymous_role;    // none, viewer, player, director, admin; empty: see exposure.h
    int leeway_seconds = 30;       // by which clocks may differ
    std::string audit_log;         // a file; empty: standard error

    bool operator==(const AuthSettings&) const = default;
};

// How much one subject may ask for; what flows in at once is a minute's worth, of queries a
// second's. Who is anonymous is counted by address alone.
struct QuotaSettings {
    double creates_per_minute = 20;
    double joins_per_minute = 120;
    double queries_per_second = 100;
    double address_factor = 10;  // an address may hold several people: so many times as much
    double refused_logins_per_minute = 30;    // of an address, before its tokens are not looked at
    double refusals_audited_per_minute = 60;  // of an address; the others are counted
    int buckets_max = 20000;                  // counted subjects and addresses; the idlest goes

    bool operator==(const QuotaSettings&) const = default;
};

// Connections to one port. What a server can hold is what the system gives it in descriptors.
struct ConnectionLimits {
    int total_max = 4000;       // more are closed at once
    int per_address_max = 512;  // of one IPv4 address or IPv6 /64
    // Sent but not (yet) a message: of one connection, and of all together. Beyond it the one with
    // the most is cut.
    double buffered_bytes_max = 8e6;
    double buffered_total_bytes_max = 64e6;
    double idle_timeout_seconds = 300;  // without a call
};

// Never where people play.
struct DevelopmentSettings {
    // A link that is worse than the real one, to every client and back, as in
    // "delay=80,jitter=20,stalls=250" (jostle/base/network_simulator.h); empty: the real one.
    std::string network_conditions;
    std::vector<std::string>
        network_conditions_worlds;  // names of the worlds that have it; empty: all
};

// Snapshots, acks and inputs as datagrams, for clients that ask for it (docs/protocol.md).
struct DatagramSettings {
    std::string listen;       // HOST:PORT of UDP; empty: all goes by the stream
    int advertised_port = 0;  // that clients are told, where it is another one outside; 0: listen's

    bool operator==(const DatagramSettings&) const = default;
};

// What outlives the process (docs/persistence.md).
struct PersistenceSettings {
    std::string
        database;  // an SQLite file, made if there is none; empty: worlds end with the process
    // "machine": what clients were told survives the end of the machine; "process": that of the
    // process, however it ends; "none": as without a store.
    std::string durability = "machine";
    double checkpoint_interval_seconds = 60;  // a world that moves is written whole so often
    double replay_seconds_max = 2;            // or when its steps since then took so long
    double history_retention_hours = 0;  // that can be gone back to; 0: the last two checkpoints

    bool is_on() const { return !database.empty() && durability != "none"; }
};

struct Config {
    std::string listen = "127.0.0.1:50051";  // gRPC
    std::string http = "127.0.0.1:8080";     // viewer, WebSocket, health
    std::string admin = "127.0.0.1:9464";    // metrics, health, profiles; empty: nothing listens
    std::string web_root = "clients/web/dist";
    std::vector<std::string> scenes = {"sandbox"};  // one world each: catalogue names or files
    std::vector<std::string> allowed_origins;       // pages from elsewhere that may use this server
    std::vector<std::string> allowed_hosts;         // own names, beside IP addresses and localhost
    std::string log_level = "info";                 // trace, debug, info, warn, error
    std::string log_format = "text";                // text, json
    // The host name that clients are sent to, for a server that listens on all addresses; empty:
    // the name of the machine.
    std::string advertised_host;
    double drain_timeout_seconds = 5;  // after SIGTERM, for clients to leave
    int network_threads = 1;           // gRPC play streams; each owns its clients
    ClientLimits client;
    ConnectionLimits connection;
    WorldLimits world;
    SceneLimits scene;
    TickSettings tick;
    StreamSettings stream;
    DatagramSettings datagrams;
    TlsSettings tls;
    AuthSettings auth;
    QuotaSettings quota;
    PersistenceSettings persistence;
    DevelopmentSettings development;
    bool insecure = false;  // reachable by strangers without TLS or tokens, on purpose
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
