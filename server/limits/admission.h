// SPDX-License-Identifier: MIT
//
// Checks an input before it is queued for the world: value ranges, rights, rates. The world itself
// checks conditions that only it knows: whether the entity exists, its owner, the number of owned
// bodies.
#pragma once

#include "jostle/base/result.h"
#include "server/config/config.h"
#include "server/util/token_bucket.h"
#include "server/world/command.h"

namespace jostle::server {

inline constexpr int spawned_hull_points_max = 32;
inline constexpr std::size_t message_recipients_max = 16;
inline constexpr char spawned_shapes_allowed[] =
    "allowed are sphere, capsule, box, cylinder, cone, and hull of at most 32 points, with sizes "
    "from 0.05 to 2 m";

// Checks the limits of play.proto: sizes 0.05 to 2 m, spawn speed 50 m/s, explosions 20 m and 20
// m/s, coordinates 10 km.
Status check_numbers(const Action& action);

// The admission state of one client.
class Admission {
public:
    Admission(const ClientLimits& limits, bool spectator, Clock::time_point now);

    // Charges a received message. Returns false if the client exceeds its message or byte rate.
    bool admit_message(std::size_t bytes, Clock::time_point now);
    Status admit_input(const Action& action, Clock::time_point now);

private:
    Status admit_user_message(const SendMessageCommand& message, Clock::time_point now);
    Status admit_attributes(const SetAttributesCommand& command, Clock::time_point now);

    ClientLimits limits_;
    bool spectator_;
    TokenBucket messages_, bytes_, inputs_, user_messages_, attribute_changes_;
};

}  // namespace jostle::server
