// SPDX-License-Identifier: MIT
//
// Simulated network between a session and its client, for development: messages in both directions
// arrive late and in order. A ClientSession has one if the configuration impairs its world. The
// transport asks for messages once per frame of the world, so delays are accurate to a tick. One
// thread.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "jostle/base/network_queue.h"
#include "server/config/config.h"
#include "server/messages/out_message.h"
#include "server/util/clock.h"

namespace jostle::server {

class SessionNetworkSimulator {
public:
    // `client`: clients with different numbers have different random sequences, the same in each
    // run.
    SessionNetworkSimulator(const NetworkConditions& conditions, std::uint32_t client)
        : incoming_(conditions, 2 * client), outgoing_(conditions, 2 * client + 1) {}

    void push_incoming(std::string_view bytes, Clock::time_point now) {
        incoming_.push(std::string(bytes), now);
    }
    // Returns the next message that has arrived. `at_once`: or that is in transit, because the
    // connection has ended.
    std::optional<std::string> take_incoming(Clock::time_point now, bool at_once = false) {
        return at_once ? incoming_.take_next() : incoming_.take(now);
    }
    void push_outgoing(OutMessage message, Clock::time_point now) {
        outgoing_.push(std::move(message), now);
    }
    std::optional<OutMessage> take_outgoing(Clock::time_point now, bool at_once = false) {
        return at_once ? outgoing_.take_next() : outgoing_.take(now);
    }

private:
    NetworkQueue<std::string> incoming_;
    NetworkQueue<OutMessage> outgoing_;
};

// Returns null for worlds without impairments. Precondition: check() accepted the settings.
inline std::unique_ptr<SessionNetworkSimulator> make_network_simulator(
    const DevelopmentSettings& settings, const std::string& world_name, std::uint32_t client) {
    const Result<NetworkConditions> conditions =
        parse_network_conditions(settings.network_conditions);
    if (!conditions.ok() || !conditions->impaired()) return nullptr;
    const auto& worlds = settings.network_conditions_worlds;
    if (!worlds.empty() && std::ranges::find(worlds, world_name) == worlds.end()) return nullptr;
    return std::make_unique<SessionNetworkSimulator>(*conditions, client);
}

}  // namespace jostle::server
