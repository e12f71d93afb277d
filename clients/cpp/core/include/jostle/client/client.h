// SPDX-License-Identifier: MIT
//
// The C++ client: joins a world over gRPC, sends inputs, keeps a decoded view of the world. Many
// clients may share one Loop, which is one thread. Functions of Client may be called from any
// thread.
//
//     client::Loop loop;
//     auto me = client::Client::connect(loop, {.target = "localhost:50051", .world = "sandbox"});
//     me->send(input);
//     me->read([](const client::WorldView& world) { ... });
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "jostle/client/client_options.h"
#include "jostle/client/client_stats.h"
#include "jostle/client/clock_sync.h"
#include "jostle/client/interpolation.h"
#include "jostle/client/loop.h"
#include "jostle/client/world_view.h"

namespace jostle::client {

struct ClientState;

class Client {
public:
    // Returns at once; the loop connects. stats().connected tells when the server has welcomed it.
    static std::shared_ptr<Client> connect(Loop& loop, ClientOptions options);
    ~Client();  // cancels the stream, and with it what was not sent: see leave()

    // Queues an input and returns its sequence number. Returns 0 and does not take the input when
    // 4096 wait already, because the server is away or slow. Up to 32 leave together, thirty times
    // a second. What was not sent when a connection broke, or did not come, is sent by the next
    // one: under its number if the client was resumed, else under new ones from 1, and then only
    // what was not sent.
    std::uint32_t send(v1::Input input);
    // For inputs that name their tick: where the InputClock is, in ticks, and the next whole one. 0
    // before it is known.
    double input_position(Clock::time_point now);
    std::uint32_t input_tick(Clock::time_point now);
    // What it wants to be told of from now on, if ClientOptions::sight was set: else it is told of
    // all.
    void set_interest(const AreaOfInterest& interest);
    // The server sends a snapshot without a base soon (4 a second at most): from it on a recording
    // can be played.
    void request_keyframe();
    // Sends what is queued and says goodbye: the stream ends in order.
    void leave();

    // Calls reader(view) under the client's lock. The reader keeps no reference and calls nothing
    // of this client.
    void read(const std::function<void(const WorldView&)>& reader) const;
    // Poses to draw now: InterpolationBuffer::sample(). Once a picture, with times that rise.
    std::vector<SmoothPose> interpolated(Clock::time_point now);
    // The moment that the last picture showed, for Aim.seen and QueryOptions::seen; for who draws
    // none that of the newest frame. Tick 0: there is none yet.
    v1::ViewTime rendered_time() const;
    // Since the last call; of more than 4096 the oldest are gone.
    std::vector<v1::InputResult> take_results();
    // What happened since the last call, one entry per tick in which something did, in order. Of
    // more than 1024 the oldest are gone; `missed` of the next one then counts them as well.
    std::vector<v1::Events> take_events();
    // How old each snapshot was when it was decoded, ms, since the last call. Of more than 65536
    // the newest are left out.
    std::vector<float> take_ages_ms();
    ClientStats stats() const;
    // What the server last told of its world; nothing before it did.
    std::optional<v1::WorldStats> world_stats() const;

private:
    explicit Client(std::shared_ptr<ClientState> state);
    std::shared_ptr<ClientState> state_;  // shared with the loop: the last of the two lets go
};

}  // namespace jostle::client
