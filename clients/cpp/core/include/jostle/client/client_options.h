// SPDX-License-Identifier: MIT
//
// Where a client connects to, who it is, and what it asks for.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "jostle/client/clock_sync.h"
#include "jostle/client/network_simulator.h"
#include "jostle/client/security.h"

namespace jostle::client {

// A circle on the ground.
struct AreaOfInterest {
    double x = 0, z = 0;  // m
    double radius = 0;    // m, from 1; 0: all of the world
};

struct ClientOptions {
    std::string target = "localhost:50051";  // of the server's gRPC port
    Security security;
    std::string world;              // name or id; empty: the server's first
    std::string ticket;             // from WorldClient::join, when the server asks for one
    std::string name;               // shown to others; at most 32 bytes
    std::uint32_t snapshot_hz = 0;  // snapshots a second that it wants; 0: the world's rate
    bool spectator = false;         // the server refuses its inputs
    bool events = false;            // asks for what happens in the world: Client::take_events()
    // Kinds of channels that it understands (WorldView::channels()); "*": all. What is not named is
    // not sent.
    std::vector<std::string> channels = {};
    // The highest codec of snapshots that it asks for: 2 has two thirds of the bytes of 1 and takes
    // about twice the time to decode.
    std::uint32_t codec = 2;
    // kbit/s that the server may send, of all that it sends, from 16; 0: what the world takes.
    std::uint32_t max_kbps = 0;
    // The part of the world that it is told of at first; Client::set_interest() moves it. Without
    // one it is told of all.
    std::optional<AreaOfInterest> interest = {};
    // Takes snapshots and sends inputs as datagrams where the server offers them, for links that
    // lose packets; while they do not get through, all goes by the stream. Not for a client with a
    // sight, a bound of kbit/s or a link that only pretends to be bad.
    bool datagrams = false;
    // Connects again after a stream that ended, with pauses that grow to 5 s.
    bool reconnect = true;
    // Is then the client that it was: the same id, its bodies, no input lost or applied twice, and
    // snapshots that go on from the last one. The server keeps its place for a while.
    bool resume = true;
    // Each input is meant for a tick (InputClock) and waits for it at the server, so that the
    // client can foresee what it does. Costs about a tick of delay.
    bool timed_inputs = false;
    // An Aim that names no moment gets that of the last picture (Client::rendered_time), so that
    // the server judges it by what was seen. Else it is judged by the world as it is when it
    // arrives.
    bool attach_view_time = true;
    // For tests and demonstrations: a link that is worse than the real one, in both directions, to
    // a millisecond.
    NetworkConditions network_conditions = {};
    // Is handed each message as it came, before anything is made of it: recordings (without
    // datagrams, for what is late is of no use to them). Called on the
    // loop's thread; it must be quick and call nothing of this client.
    std::function<void(const std::string& bytes, Clock::time_point now)> on_message = {};
};

}  // namespace jostle::client
