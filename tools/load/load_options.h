// SPDX-License-Identifier: MIT
//
// The plan of a load run: server, clients and duration, from the flags of jostle-load.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "clients/bot/script.h"
#include "jostle/client/client_options.h"
#include "jostle/client/security.h"
#include "tools/load/data_traffic.h"

namespace jostle::load {

enum class Transport { grpc, websocket, raw };

struct LoadOptions {
    std::string target;  // HOST:PORT
    client::Security security;
    std::string world;
    int clients = 10;
    int threads = 2;
    double ramp = 1, settle = 1, seconds = 10;  // s
    bot::Script script;                         // empty: the clients only receive
    // m; radius of each client's area of interest; 0: the whole world. The centres are evenly
    // distributed in a disc of that radius about the origin.
    double interest_radius = 0;
    std::uint32_t max_kbps = 0;     // bandwidth limit per client, kbit/s; 0: none
    std::uint32_t snapshot_hz = 0;  // requested snapshot rate, Hz; 0: the tick rate of the world
    std::optional<client::Precision> precision = {};  // nothing: that of the world

    // Area of interest of a client, numbered from 0.
    std::optional<client::AreaOfInterest> interest_of(int number) const;
    // Read rate of a client, numbered from 0; 0: unlimited.
    double read_rate_of(int number) const;

    DataOptions data;  // user messages and attributes

    bool datagrams = false;  // of library clients: ClientOptions::datagrams

    // Of passive clients. Raw: messages with a length prefix (framing.h), for benchmark
    // servers.
    Transport transport = Transport::grpc;
    int ack_every = 0;     // snapshots per ack; 0: at the interval of the Welcome
    double read_rate = 0;  // messages per second that each client reads; 0: unlimited
    // Each client has a read rate of its own between read_rate and this; 0: all have read_rate.
    double read_rate_max = 0;
    double decode_ratio = 0.01;  // share of the clients that decode; 0: none
};

}  // namespace jostle::load
