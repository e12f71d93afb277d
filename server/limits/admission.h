// SPDX-License-Identifier: MIT
//
// May this input go to the world? Numbers in range, rights, rates. What only the world knows (does
// the entity exist, is it yours, how many do you own) is decided there.
#pragma once

#include "jostle/base/result.h"
#include "server/config/config.h"
#include "server/util/token_bucket.h"
#include "server/world/command.h"

namespace jostle::server {

inline constexpr int spawned_hull_points_max = 32;
inline constexpr char spawned_shapes_allowed[] =
    "allowed are sphere, capsule, box, cylinder, cone, and hull of at most 32 points, with sizes "
    "from 0.05 to 2 m";

// The limits of play.proto: sizes 0.05 to 2 m, spawn speed 50 m/s, explosions 20 m and 20 m/s,
// coordinates 10 km.
Status check_numbers(const Action& action);

// Per client.
class Admission {
public:
    Admission(const ClientLimits& limits, bool spectator, Clock::time_point now);

    // A message of that size arrived: false when the client sends too many or too much.
    bool admit_message(std::size_t bytes, Clock::time_point now);
    Status admit_input(const Action& action, Clock::time_point now);

private:
    ClientLimits limits_;
    bool spectator_;
    TokenBucket messages_, bytes_, inputs_;
};

}  // namespace jostle::server
