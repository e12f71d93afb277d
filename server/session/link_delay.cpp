// SPDX-License-Identifier: MIT
#include "server/session/link_delay.h"

#include <algorithm>
#include <utility>

namespace jostle::server {

namespace {

LinkConditioner seeded(LinkSettings settings, std::uint32_t number) {
    settings.seed += number;
    return LinkConditioner(settings);
}

}  // namespace

// Another link back.
LinkDelay::LinkDelay(LinkSettings settings, std::uint32_t number)
    : heard_{seeded(settings, 2 * number)}, said_{seeded(settings, 2 * number + 1)} {}

template <class Message>
void LinkDelay::put(Way<Message>& way, Message message, Clock::time_point now) {
    const std::int64_t due_us = way.link.arrival_us(static_cast<std::int64_t>(to_us(now)));
    way.held.push_back({std::move(message), due_us});
}

template <class Message>
std::optional<Message> LinkDelay::take(Way<Message>& way, Clock::time_point now, bool at_once) {
    if (way.held.empty()) return std::nullopt;
    if (!at_once && way.held.front().due_us > static_cast<std::int64_t>(to_us(now)))
        return std::nullopt;
    Message message = std::move(way.held.front().message);
    way.held.pop_front();
    return message;
}

void LinkDelay::hear(std::string_view bytes, Clock::time_point now) {
    put(heard_, std::string(bytes), now);
}

std::optional<std::string> LinkDelay::take_heard(Clock::time_point now, bool at_once) {
    return take(heard_, now, at_once);
}

void LinkDelay::say(OutMessage message, Clock::time_point now) {
    put(said_, std::move(message), now);
}

std::optional<OutMessage> LinkDelay::take_said(Clock::time_point now, bool at_once) {
    return take(said_, now, at_once);
}

std::unique_ptr<LinkDelay> link_delay_for(const DevelopmentSettings& settings,
                                          const std::string& world_name, std::uint32_t number) {
    const Result<LinkSettings> link = read_link_settings(settings.network_conditions);
    if (!link.ok() || !link->bad()) return nullptr;
    const auto& worlds = settings.network_conditions_worlds;
    if (!worlds.empty() && std::ranges::find(worlds, world_name) == worlds.end()) return nullptr;
    return std::make_unique<LinkDelay>(*link, number);
}

}  // namespace jostle::server
