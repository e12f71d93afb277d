// SPDX-License-Identifier: MIT
//
// Closes the rooms whose settings request it after their last client left. One thread.
#pragma once

#include <map>
#include <string>

#include "server/session/play_context.h"
#include "server/util/clock.h"

namespace jostle::server {

class EmptyRooms {
public:
    // After this time without a client, or if none ever came, after this one.
    static constexpr Clock::duration empty_time = std::chrono::seconds(10);
    static constexpr Clock::duration first_client_time = std::chrono::seconds(120);

    // Call it about once per second.
    void close(PlayContext& context, Clock::time_point now);

private:
    std::map<std::string, Clock::time_point> empty_since_;  // by world id
};

}  // namespace jostle::server
