// SPDX-License-Identifier: MIT
//
// The address of a server, the identity of a client, and the data that it requests.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "jostle/base/network_conditions.h"
#include "jostle/client/clock_sync.h"
#include "jostle/client/security.h"

namespace jostle::client {

/// A circle on the ground.
struct AreaOfInterest {
    double x = 0, z = 0;  ///< m, centre
    double radius = 0;    ///< m, at least 1; 0: the whole world
};

/// The greatest error of decoded poses. The server rounds both down to 1, 2 or 5 times a power of
/// ten.
struct Precision {
    double position = 0;    ///< m, 0.0001 to 1
    double rotation = 0;    ///< rad, 0.0002 to 0.5
    double far_factor = 1;  ///< coarser beyond half of the radius of interest, 1 to 1000
};

/// Options of Client::connect().
struct ClientOptions {
    std::string target = "localhost:50051";  ///< host:port of the server's gRPC listener
    Security security;
    std::string world;              ///< name or id; empty: the first world of the server
    std::string ticket;             ///< from WorldClient::join(), if the server requires one
    std::string name;               ///< display name; at most 32 bytes
    std::uint32_t snapshot_hz = 0;  ///< requested snapshot rate, Hz; 0: the tick rate of the world
    bool spectator = false;         ///< the server rejects its inputs
    bool events = false;            ///< subscribes to events: Client::take_events()
    /// Channel kinds to subscribe to (WorldView::channels() and points()); "*": all kinds of
    /// modules; "points:*": all kinds with point objects. The server sends no other kinds.
    std::vector<std::string> channels = {};
    /// Receives the joints of the world: WorldView::joints().
    bool joints = false;
    bool players = false;     ///< subscribes to the player list: WorldView::data()
    bool attributes = false;  ///< subscribes to attributes: WorldView::data()
    bool room = false;        ///< subscribes to the settings of the room: WorldView::data()
    /// Topics of user messages to subscribe to, at most 64: Client::take_messages(); "*": all.
    std::vector<std::string> topics = {};
    std::optional<std::uint32_t> color = {};  ///< 0xRRGGBB, of the player; absent: none
    /// The highest snapshot codec to request, 1 or 2. Codec 2 needs two thirds of the bytes of
    /// codec 1 and about twice the time to decode.
    std::uint32_t codec = 2;
    /// Bandwidth limit for everything that the server sends, kbit/s, at least 16; 0: no limit.
    std::uint32_t max_kbps = 0;
    /// Receives entity lists packed, which takes about one hundredth of the bytes in scenes of
    /// equal bodies. A recorder for earlier versions of jostle-replay does not.
    bool packed_entities = true;
    /// Initial area of interest; Client::set_interest() moves it. Absent: the whole world.
    std::optional<AreaOfInterest> interest = {};
    /// Precision of the poses for this client. Absent: that of the world. Prediction expects at
    /// most 0.002 m and 0.005 rad.
    std::optional<Precision> precision = {};
    /// Receives snapshots and sends inputs as datagrams if the server supports them, for
    /// connections that lose packets. While datagrams do not get through, the stream carries
    /// everything. Not available together with an area of interest, a bandwidth limit or simulated
    /// network conditions.
    bool datagrams = false;
    /// Reconnects after a stream has ended, with delays that increase to 5 s.
    bool reconnect = true;
    /// Resumes the session when it reconnects: same client id and bodies, no input lost or applied
    /// twice, and snapshots that continue from the last one. The server retains the session for a
    /// limited time.
    bool resume = true;
    /// Assigns a tick (InputClock) to each input, for which the input waits at the server, so that
    /// the client can predict its effect. Adds a delay of about one tick.
    bool timed_inputs = false;
    /// Sets the view time of an Aim without one to the last rendered frame (Client::rendered_time),
    /// so that the server evaluates it against the view of the player. Otherwise the server
    /// evaluates it against the world at the time of arrival.
    bool attach_view_time = true;
    /// Simulated network conditions in both directions, accurate to 1 ms, for tests and
    /// demonstrations.
    NetworkConditions network_conditions = {};
    /// Receives each message as it arrived, before it is processed; for recordings (without
    /// datagrams, because a recording cannot use late snapshots). Called on the loop's thread. It
    /// must be quick and must not call functions of this client.
    std::function<void(const std::string& bytes, Clock::time_point now)> on_message = {};
    /// Join code of a private room; a ticket replaces it.
    std::string join_code = {};
};

}  // namespace jostle::client
