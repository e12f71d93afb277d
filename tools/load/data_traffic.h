// SPDX-License-Identifier: MIT
//
// The user messages and attributes of one load client: attributes of its player at the start, then
// changes and chat messages at steady rates. One thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "jostle/client/clock_sync.h"
#include "jostle/v1/play.pb.h"

namespace jostle::load {

using client::Clock;

struct DataOptions {
    double messages_per_second = 0;  // of each client, to all clients
    int attributes = 0;              // of each player
    double attribute_changes_per_second = 1;

    bool is_on() const { return messages_per_second > 0 || attributes > 0; }
};

inline constexpr const char* chat_topic = "chat";

class DataTraffic {
public:
    // `number`: of the client; shifts its times, so that clients do not send at once.
    DataTraffic(const DataOptions& options, int number) : options_(options), number_(number) {}

    // The inputs that are due. `client_id`: of the joined client.
    std::vector<v1::Input> take(Clock::time_point now, std::uint32_t client_id);

private:
    v1::Input attributes(std::uint32_t client_id, int first, int count);

    const DataOptions options_;
    const int number_;
    std::optional<Clock::time_point> began_;  // nothing: it has not joined
    std::uint64_t messages_ = 0, changes_ = 0;
};

// The time at which a client of this process sent a chat message, us; nothing: another sender.
std::optional<std::uint64_t> sent_us(std::string_view data);

}  // namespace jostle::load
