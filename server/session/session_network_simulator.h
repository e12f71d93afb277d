// SPDX-License-Identifier: MIT
//
// A link that is worse than the real one, for development: what a client said is heard later, and
// what it is told leaves later, in order. A ClientSession has one when its world's settings say so.
// The transport asks for messages with each frame of the world, so times are good to a tick. One
// thread.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "jostle/base/network_simulator.h"
#include "server/config/config.h"
#include "server/messages/out_message.h"
#include "server/util/clock.h"

namespace jostle::server {

class SessionNetworkSimulator {
public:
    // `number`: of the client, so that each has stalls of its own; the same in each run.
    SessionNetworkSimulator(NetworkConditions settings, std::uint32_t number);

    void push_incoming(std::string_view bytes, Clock::time_point now);
    // The next one that has arrived. `at_once`: or is still on its way, for the line is cut.
    std::optional<std::string> take_incoming(Clock::time_point now, bool at_once = false);
    void push_outgoing(OutMessage message, Clock::time_point now);
    std::optional<OutMessage> take_outgoing(Clock::time_point now, bool at_once = false);

private:
    template <class Message>
    struct Direction {
        struct DelayedMessage {
            Message message;
            std::int64_t due_us;
        };
        NetworkSimulator link;
        std::deque<DelayedMessage> delayed = {};
    };

    template <class Message>
    static void put(Direction<Message>& direction, Message message, Clock::time_point now);
    template <class Message>
    static std::optional<Message> take(Direction<Message>& direction, Clock::time_point now,
                                       bool at_once);

    Direction<std::string> incoming_;
    Direction<OutMessage> outgoing_;
};

// Null: clients of that world have the real link. The settings were checked.
std::unique_ptr<SessionNetworkSimulator> make_network_simulator(const DevelopmentSettings& settings,
                                                                const std::string& world_name,
                                                                std::uint32_t number);

}  // namespace jostle::server
