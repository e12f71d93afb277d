// SPDX-License-Identifier: MIT
//
// Every setting of the server in one struct, with its unit and its default. The values come from
// the defaults, then the TOML file (config_loader.h), then the flags, and are checked once at
// start.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "jostle/base/result.h"

namespace jostle::server {

// Limits per client. The defaults allow intensive play and stop a script that floods the server.
struct ClientLimits {
    double messages_per_second = 90;  // ClientMessages, in addition to one Ack per snapshot
    double bytes_per_second = 65536;
    double inputs_per_second = 300;
    int message_bytes_max = 65536;
    int inputs_per_batch_max = 64;
    double user_messages_per_second = 5;
    int user_message_bytes_max = 1024;
    double attribute_changes_per_second = 100;
    int attribute_bytes_max = 32768;  // of all attributes that one client set in a world
    int bodies_owned_max = 50;
    int joints_owned_max = 100;
    int account_bodies_max = 500;  // of all clients of a subject or network; 0: unlimited
    // false: bodies spawned by a client are removed when it leaves
    bool retain_bodies_after_leave = false;
    double retained_bodies_seconds = 0;  // then they are removed as well; 0: they stay
    // How long the session of a client that can resume is retained after its connection broke; 0
    // disables resuming.
    double resume_timeout_seconds = 30;
};

// Limits on the sessions of players. 0 disables each.
struct SessionLimits {
    // A player whose client sends no input for this long is disconnected; spectators are exempt.
    double idle_kick_seconds = 0;
    // Sessions of one subject. A further one is refused, but takes the place of a suspended one.
    // Anonymous callers have no subject and are not counted.
    int sessions_per_subject = 0;

    bool operator==(const SessionLimits&) const = default;
};

struct WorldLimits {
    int worlds_max = 64;
    int bodies_max = 20000;             // per world
    int bodies_total_max = 50000;       // in all worlds together; about 5 kB of memory each
    int clients_max = 1000;             // per server
    int clients_per_address_max = 250;  // per IPv4 address or IPv6 /64
    double spawn_load_max = 0.7;   // busy share of the tick period up to which clients may spawn
    int command_queue_max = 8192;  // commands waiting for a tick; if full, the input is refused
    int attributes_per_target_max = 32;  // of a world, a player or an entity
    int attribute_text_bytes_max = 256;
    int attribute_bytes_max = 1 << 20;              // of all attributes of a world
    double user_message_bytes_per_second = 262144;  // of all clients of a world; 0: unlimited
};

// Limits on the cost of a hosted scene (server/world/scene_budget.h defines each).
struct SceneLimits {
    int request_bytes_max = 32 << 20;  // of a scene that is created or exported
    int joints_max = 20000;
    int joints_per_pair_max = 64;
    double geometry_bytes_max = 32e6;
    int body_geometry_bytes_max = 65536;
    double work_per_second_max = 2e8;
    int pairs_per_shape_max = 16;            // 0: unlimited
    double work_total_per_second_max = 4e8;  // in all worlds together
    double first_step_seconds_max = 0.5;
};

struct TickSettings {
    // A late world runs up to this many ticks at once to catch up. Further late ticks are skipped
    // and counted, so that a stall of the machine is not followed by a burst.
    int catch_up_ticks_max = 4;
    int threads = 0;          // for the ticks of all worlds; 0: one per processor, at least two
    int physics_threads = 1;  // per world
    // Share of the tick period for inputs, divided evenly among the players that send some; 0:
    // unlimited. Inputs beyond it wait for later ticks, at most this long.
    double input_share = 0.25;
    double input_wait_seconds_max = 0.5;
    // Share of the tick period for copies of the world that queries are evaluated against; 0:
    // unlimited. Beyond it, the world is copied in fewer ticks, and queries see an older state.
    double query_copy_share = 0.1;
    // Processor time of the tick thread. A tick that uses more is interrupted and its world is
    // paused for a while, so that it does not delay other worlds.
    double step_seconds_max = 1;
    // Maximum age of the view time of a query or an aim: the client's round-trip delay plus its
    // interpolation delay. The server retains frames for this long.
    double lag_compensation_ms_max = 400;
};

struct StreamSettings {
    // The longest time for which snapshots may be unacknowledged, on any path.
    int ack_window_max_ms = 3000;
    int ack_interval_ms = 100;         // interval of the client's acknowledgements
    double hello_timeout_seconds = 5;  // a stream without a Hello is closed after this time
    // a client that sends nothing for this long is disconnected
    double client_timeout_seconds = 10;
    double stats_per_second = 2;
    int codec = 2;                // of snapshots: the highest codec that the server offers
    double interest_cell_m = 32;  // cell edge of the interest grid
    // Greatest error of decoded poses in worlds and for clients that do not set their own; both 0:
    // the nearest units of 2 mm and 0.2 degrees.
    double position_precision_m = 0, rotation_precision_rad = 0;
    double far_precision_factor = 1;  // coarser beyond half of the radius of interest
    // Snapshots per second to a client while nothing moves in its world.
    double heartbeats_per_second = 4;
};

// Certificates of both listeners in PEM format; read again when they change.
struct TlsSettings {
    std::string certificate;  // the server's own certificate, then the chain to its root
    std::string key;          // without a passphrase
    std::string client_ca;    // a client with a certificate issued by this CA is an admin

    bool operator==(const TlsSettings&) const = default;
};

// Trusted tokens, and the role of anonymous clients (docs/guides/operator/secure.md).
struct AuthSettings {
    std::string issuer, audience;  // "iss" and "aud" of every token
    std::string keys;              // JWKS file; empty: every token is rejected
    std::string anonymous_role;    // none, viewer, player, director, admin; empty: see exposure.h
    int leeway_seconds = 30;       // tolerated clock difference
    std::string audit_log;         // a file; empty: standard error

    bool operator==(const AuthSettings&) const = default;
};

// Rate limits per subject. The burst is one minute's worth, for queries one second's. Anonymous
// clients are counted by address alone.
struct QuotaSettings {
    double creates_per_minute = 20;
    double joins_per_minute = 120;
    double queries_per_second = 100;
    // Share of one processor for all queries, divided evenly among the players that send some; 0:
    // unlimited.
    double query_share = 0.5;
    // limits per address are this factor higher, because several people may share an address
    double address_factor = 10;
    // per address; beyond it, its tokens are rejected unread
    double refused_logins_per_minute = 30;
    double refusals_audited_per_minute = 60;  // per address; further refusals are only counted
    int buckets_max = 20000;  // tracked subjects and addresses; the longest idle is evicted

    bool operator==(const QuotaSettings&) const = default;
};

// Limits per port. The limit on file descriptors bounds them as well.
struct ConnectionLimits {
    int total_max = 4000;       // further connections are closed at once
    int per_address_max = 512;  // per IPv4 address or IPv6 /64
    // Bytes received that do not form a complete message yet: of one connection, and of all
    // together. Beyond the limit the connection with the most bytes is closed.
    double buffered_bytes_max = 8e6;
    double buffered_total_bytes_max = 64e6;
    double idle_timeout_seconds = 300;  // without a call
};

// Development only; never use these settings on a server with players.
struct DevelopmentSettings {
    // Emulated network conditions for every client in both directions, such as
    // "latency_ms=80,jitter_ms=20,stall_ms=250" (jostle/base/network_conditions.h); empty: no
    // emulation.
    std::string network_conditions;
    std::vector<std::string> network_conditions_worlds;  // names of affected worlds; empty: all
};

// Snapshots, acks and inputs as datagrams, for clients that request them
// (docs/design/datagrams.md).
struct DatagramSettings {
    std::string listen;  // HOST:PORT of UDP; empty: no datagrams
    // port that clients are sent, if it differs from the local port; 0: the port of `listen`
    int advertised_port = 0;

    bool operator==(const DatagramSettings&) const = default;
};

// Persistence of worlds across processes (docs/design/persistence.md).
struct PersistenceSettings {
    std::string database;  // SQLite file, created if missing; empty: worlds end with the process
    // Acknowledged inputs survive "machine": a power failure; "process": a crash of the process;
    // "none": nothing, as without a database.
    std::string durability = "machine";
    double checkpoint_interval_seconds = 60;  // interval of full checkpoints of a world that moves
    double replay_seconds_max = 2;            // a checkpoint is also due after this much step time
    // how far back a world can be restored; 0: the last two checkpoints
    double history_retention_hours = 0;
    // Continues with what can be read of a damaged database. For one start, therefore a flag and
    // not a setting: --accept-damage.
    bool accept_damage = false;

    bool is_on() const { return !database.empty() && durability != "none"; }
};

struct Config {
    std::string listen = "127.0.0.1:50051";  // gRPC
    std::string http = "127.0.0.1:8080";     // viewer, WebSocket, health
    std::string admin = "127.0.0.1:9464";    // metrics, health, profiles; empty: disabled
    std::string web_root = "clients/web/dist";
    std::vector<std::string> scenes = {"sandbox"};  // one world each: catalogue names or files
    std::vector<std::string> allowed_origins;  // additional origins whose pages may use this server
    // own host names, in addition to IP addresses and localhost
    std::vector<std::string> allowed_hosts;
    // Addresses and networks of the proxies in front of this server, whose statements about their
    // clients are believed (server/forwarding/trusted_proxies.h).
    std::vector<std::string> trusted_proxies;
    // header of a trusted proxy with the client's address: x-forwarded-for, forwarded
    std::string forwarded_header = "x-forwarded-for";
    // ports on which connections of trusted proxies begin with a PROXY v2 header: grpc, http
    std::vector<std::string> proxy_protocol;
    std::string log_level = "info";   // trace, debug, info, warn, error
    std::string log_format = "text";  // text, json
    // Host name that clients connect to, for a server that listens on all addresses; empty: the
    // host name of the machine.
    std::string advertised_host;
    double drain_timeout_seconds = 5;  // time for clients to leave after SIGTERM
    int network_threads = 1;           // gRPC play streams; each owns its clients
    ClientLimits client;
    SessionLimits limits;
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
    bool insecure = false;  // allow non-loopback listeners without TLS and authentication
};

// An error names the key, the value and the range.
Status check(const Config& config);

struct HostPort {
    std::string host;
    std::uint16_t port = 0;
};
// Parses "127.0.0.1:8080", "[::1]:8080" or "localhost:0" (port 0: any free port).
Result<HostPort> parse_host_port(const std::string& text);

}  // namespace jostle::server
