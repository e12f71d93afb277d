// SPDX-License-Identifier: MIT
//
// The C++ client: joins a world over gRPC, sends inputs and maintains a decoded view of the world.
// Many clients may share one Loop (one thread). All functions of Client may be called from any
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

/// A client in one world: its connection, its inputs and its view of the world.
class Client {
public:
    /// Creates a client and returns immediately; the loop connects it. stats().connected becomes
    /// true when the server has sent its Welcome.
    static std::shared_ptr<Client> connect(Loop& loop, ClientOptions options);
    ~Client();  ///< cancels the stream and discards unsent inputs; see leave()

    /// Queues an input and returns its sequence number. Returns 0 and discards the input if 4096
    /// inputs are queued already, because the server is unreachable or slow. The loop sends up to
    /// 32 inputs per message, 30 times per second. If the connection breaks, the next one sends the
    /// unsent inputs: with their sequence numbers if the session was resumed, else with new ones
    /// from 1.
    std::uint32_t send(v1::Input input);
    /// Position of the InputClock in ticks, for inputs that name their tick; 0 before it is known.
    double input_position(Clock::time_point now);
    /// The next whole tick of the InputClock, for Input.tick; 0 before it is known.
    std::uint32_t input_tick(Clock::time_point now);
    /// Moves the area of interest. Requires ClientOptions::interest; without it the client receives
    /// the whole world.
    void set_interest(const AreaOfInterest& interest);
    /// Requests a snapshot without baselines, for example as the start of a recording. The server
    /// sends at most 4 per second.
    void request_keyframe();
    /// Sends the queued inputs and a Leave, then closes the stream.
    void leave();

    /// Calls reader(view) under the client's lock. The reader must neither store a reference nor
    /// call functions of this client.
    void read(const std::function<void(const WorldView&)>& reader) const;
    /// Returns the poses to render now; see InterpolationBuffer::sample(). Call it once per
    /// rendered frame with increasing times.
    std::vector<SmoothPose> interpolated(Clock::time_point now);
    /// Returns the point objects at the time of the last interpolated(); see
    /// PointObjectView::sample(). Descriptions are in WorldView::points().
    std::vector<SmoothPoints> interpolated_points();
    /// The world time of the last rendered frame, for Aim.view_time and QueryOptions::view_time.
    /// Without rendering: of the newest received frame. Tick 0: no frame was received yet.
    v1::ViewTime rendered_time() const;
    /// Returns the results of inputs since the last call. Only the newest 4096 are stored.
    std::vector<v1::InputResult> take_results();
    /// Returns the events since the last call, one entry per tick with events, in order. Only the
    /// newest 1024 are stored; `missed` of the next entry counts the others.
    std::vector<v1::Events> take_events();
    /// Returns the user messages since the last call, in order (ClientOptions::topics). Only the
    /// newest 1024 are stored.
    std::vector<v1::UserMessage> take_messages();
    /// Returns the player events since the last call, in order (ClientOptions::players). Only the
    /// newest 1024 are stored. The player list is in WorldView::data().
    std::vector<v1::PlayerEvent> take_player_events();
    /// Returns the age of each snapshot when it was decoded, ms, since the last call. At most 65536
    /// are stored; later ones are discarded.
    std::vector<float> take_ages_ms();
    /// Statistics since the client was created.
    ClientStats stats() const;
    /// The newest statistics of the world from the server; nothing before the first ones.
    std::optional<v1::WorldStats> world_stats() const;

private:
    explicit Client(std::shared_ptr<ClientState> state);
    std::shared_ptr<ClientState> state_;  // shared with the loop; the last owner destroys it
};

}  // namespace jostle::client
