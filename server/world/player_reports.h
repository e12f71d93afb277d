// SPDX-License-Identifier: MIT
//
// The newest reports of players about other players of a world: user messages to the server with
// the topic "report". They are a log of the process and no part of the state of the world: they
// stay when the world is rewound, reset or restarted, and end with the process. Any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "server/util/token_bucket.h"
#include "server/util/wall_time.h"
#include "server/world/frame.h"
#include "server/world/world_properties.h"

namespace jostle::server {

struct PlayerReport {
    std::uint64_t number = 0;  // counts the reports of the world from 1
    std::uint32_t tick = 0;
    WallTime time;
    ClientId from = 0;
    std::string from_name;
    ClientId client = 0;                // reported; 0: the report names none
    std::string name;                   // of the reported client
    std::string reason;                 // all data, if it has another form
    std::vector<std::string> messages;  // quoted ones of the reported client
};

// Data of a report: a JSON object with the fields client, name, reason and messages. Fields that
// are too long are cut; other data becomes the reason.
PlayerReport parse_report(std::string_view data);

class PlayerReports {
public:
    static constexpr std::string_view topic = "report";
    // A client that sends many reports removes only its own.
    static constexpr std::size_t reports_max = 100, reports_per_client_max = 10;
    static constexpr std::size_t reason_bytes_max = 300, name_bytes_max = 64, messages_max = 8,
                                 message_bytes_max = 300;

    PlayerReports();

    // Adds the reports among the user messages that the frame has and earlier frames had not, and
    // logs each, at most 10 lines at once and 1 per second.
    void add_from(const Frame& frame, const WorldLabel& world, Clock::time_point now);
    std::vector<PlayerReport> list() const;  // oldest first

private:
    void add(PlayerReport report);
    void log(const PlayerReport& report, const WorldLabel& world, Clock::time_point now);

    mutable std::mutex mutex_;
    std::deque<PlayerReport> reports_;  // oldest first
    std::uint64_t count_ = 0;
    std::uint32_t last_message_ = 0;  // of the frames so far
    TokenBucket log_lines_;
    std::uint64_t not_logged_ = 0;
};

}  // namespace jostle::server
