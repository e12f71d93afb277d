// SPDX-License-Identifier: MIT
//
// Who is to load which server, for how long: what the flags of jostle-load say.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "clients/bot/script.h"
#include "jostle/client/client_options.h"
#include "jostle/client/security.h"

namespace jostle::load {

enum class Transport { grpc, websocket, raw };

struct LoadOptions {
    std::string target;  // HOST:PORT
    client::Security security;
    std::string world;
    int clients = 10;
    int threads = 2;
    double ramp = 1, settle = 1, seconds = 10;  // s
    bots::Script script;                        // empty: the clients only watch
    // Of the world they see what is within so many metres of a point; 0: all. The points lie evenly
    // in a disc of that radius about the origin, each client's elsewhere.
    double interest_radius = 0;
    std::uint32_t max_kbps = 0;  // that the server may send to each; 0: what the world takes

    // Of a client that sees a part; number from 0.
    std::optional<client::AreaOfInterest> interest_of(int number) const;

    bool datagrams = false;  // of clients of the library: ClientOptions::datagrams

    // Of sinks. Raw: messages with their length (raw_framing.h), as servers of benchmarks send.
    Transport transport = Transport::grpc;
    int ack_every = 0;           // snapshots; 0: as the server's welcome asks for
    double read_rate = 0;        // messages a second that each client reads; 0: as they come
    double decode_ratio = 0.01;  // of the clients; 0: none
};

}  // namespace jostle::load
