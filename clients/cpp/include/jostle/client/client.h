// SPDX-License-Identifier: MIT
//
// The C++ client: joins a world over gRPC, sends inputs, keeps a decoded view of the world. Many
// clients may share one Loop (one thread); functions of Client may be called from any thread.
//
//     client::Loop loop;
//     auto me = client::Client::connect(loop, {.target = "localhost:50051", .world = "sandbox"});
//     me->send(input);
//     me->read([](const client::WorldView& world) { ... });
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "jostle/client/clock_sync.h"
#include "jostle/client/interpolation.h"
#include "jostle/client/world_view.h"

namespace jostle::client {

struct ClientOptions {
    std::string target = "localhost:50051";
    std::string world;              // name or id; empty: the first
    std::string ticket;             // from WorldClient::join, when the server asks for one
    std::string name;               // at most 32 bytes
    std::uint32_t snapshot_hz = 0;  // 0: the world's rate
    bool spectator = false;
    bool events = false;    // asks for what happens in the world: see take_events()
    bool reconnect = true;  // after a lost connection, with growing pauses up to 5 s
};

struct ClientStats {
    bool connected = false;  // welcomed, and not ended since
    std::uint32_t client_id = 0;
    std::uint64_t snapshots = 0, bytes_received = 0;
    std::uint64_t inputs_sent = 0, inputs_applied = 0, inputs_refused = 0;
    std::uint64_t decode_errors = 0;    // snapshots that did not decode or whose CRC did not match
    std::uint64_t stream_failures = 0;  // ends that nobody asked for
    double rtt_ms = 0;
    std::string last_error;  // the newest failure, for people
};

class Loop;

class Client {
public:
    static std::shared_ptr<Client> connect(Loop& loop, ClientOptions options);
    ~Client();

    // Queues an input; returns its sequence number, or 0 when 4096 wait already (the server is away
    // or slow) and this one was not taken. Sent within a thirtieth of a second. Numbers
    // begin anew with each connection: what was not sent before a reconnect is sent after it under
    // a new number.
    std::uint32_t send(v1::Input input);
    // Says goodbye; the stream ends in order.
    void leave();

    // Calls with the view under the client's lock: do not keep references.
    void read(const std::function<void(const WorldView&)>& reader) const;
    std::vector<SmoothPose> interpolated(Clock::time_point now) const;
    // Since the last call; of more than 4096 the oldest are gone.
    std::vector<v1::InputResult> take_results();
    // What happened since the last call, one entry per tick in which something did, in order. Of
    // more than 1024 the oldest are gone; `missed` of the next one then counts them as well.
    std::vector<v1::Events> take_events();
    // Age of each snapshot when it was decoded, since the last call (at most 65536); ms.
    std::vector<float> take_ages_ms();
    ClientStats stats() const;
    std::optional<v1::WorldStats> world_stats() const;

private:
    friend class Loop;
    struct Impl;
    explicit Client(std::shared_ptr<Impl> impl);
    std::shared_ptr<Impl> impl_;
};

// One thread that moves the messages of its clients.
class Loop {
public:
    Loop();
    ~Loop();  // ends what is still connected
    Loop(const Loop&) = delete;
    Loop& operator=(const Loop&) = delete;

private:
    friend class Client;
    struct Impl;
    std::shared_ptr<Impl> impl_;
};

}  // namespace jostle::client
