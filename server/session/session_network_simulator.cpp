// SPDX-License-Identifier: MIT
#include "server/session/session_network_simulator.h"

#include <algorithm>
#include <utility>

namespace jostle::server {

namespace {

NetworkSimulator seeded(NetworkConditions settings, std::uint32_t number) {
    settings.seed += number;
    return NetworkSimulator(settings);
}

}  // namespace

// Another link back.
SessionNetworkSimulator::SessionNetworkSimulator(NetworkConditions settings, std::uint32_t number)
    : incoming_{seeded(settings, 2 * number)}, outgoing_{seeded(settings, 2 * number + 1)} {}

template <class Message>
void SessionNetworkSimulator::put(Direction<Message>& direction, Message message,
                                  Clock::time_point now) {
    const std::int64_t due_us = direction.link.arrival_us(static_cast<std::int64_t>(to_us(now)));
    direction.delayed.push_back({std::move(message), due_us});
}

template <class Message>
std::optional<Message> SessionNetworkSimulator::take(Direction<Message>& direction,
                                                     Clock::time_point now, bool at_once) {
    if (direction.delayed.empty()) return std::nullopt;
    if (!at_once && direction.delayed.front().due_us > static_cast<std::int64_t>(to_us(now)))
        return std::nullopt;
    Message message = std::move(direction.delayed.front().message);
    direction.delayed.pop_front();
    return message;
}

void SessionNetworkSimulator::push_incoming(std::string_view bytes, Clock::time_point now) {
    put(incoming_, std::string(bytes), now);
}

std::optional<std::string> SessionNetworkSimulator::take_incoming(Clock::time_point now,
                                                                  bool at_once) {
    return take(incoming_, now, at_once);
}

void SessionNetworkSimulator::push_outgoing(OutMessage message, Clock::time_point now) {
    put(outgoing_, std::move(message), now);
}

std::optional<OutMessage> SessionNetworkSimulator::take_outgoing(Clock::time_point now,
                                                                 bool at_once) {
    return take(outgoing_, now, at_once);
}

std::unique_ptr<SessionNetworkSimulator> make_network_simulator(const DevelopmentSettings& settings,
                                                                const std::string& world_name,
                                                                std::uint32_t number) {
    const Result<NetworkConditions> link = parse_network_conditions(settings.network_conditions);
    if (!link.ok() || !link->impaired()) return nullptr;
    const auto& worlds = settings.network_conditions_worlds;
    if (!worlds.empty() && std::ranges::find(worlds, world_name) == worlds.end()) return nullptr;
    return std::make_unique<SessionNetworkSimulator>(*link, number);
}

}  // namespace jostle::server
