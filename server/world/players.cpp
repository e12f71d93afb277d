// SPDX-License-Identifier: MIT
#include "server/world/players.h"

#include <algorithm>
#include <utility>

#include "jostle/base/check.h"
#include "server/util/text.h"

namespace jostle::server {

namespace {

const PlayerListPtr& empty_list() {
    static const PlayerListPtr list = std::make_shared<const PlayerList>();
    return list;
}

Error no_such_player(ClientId client) {
    return {ErrorCode::not_found, "player " + std::to_string(client) + " does not exist"};
}

}  // namespace

const Player* PlayerList::find(ClientId client) const {
    const auto at = std::ranges::lower_bound(
        players, client, {}, [](const PlayerPtr& player) { return player->client; });
    return at != players.end() && (*at)->client == client ? at->get() : nullptr;
}

Players::Players() : list_(empty_list()) {}

void Players::put(Player player, PlayerEventKind kind) {
    auto entry = std::make_shared<const Player>(std::move(player));
    players_[entry->client] = entry;
    events_.push_back({0, kind, std::move(entry)});
    changed_ = true;
}

void Players::join(const Player& player) {
    ASSERT(player.client != scene_client);
    const Player* const known = find(player.client);
    if (!known) return put(player, PlayerEventKind::joined);
    if (known->connected) return;
    Player resumed = *known;
    resumed.connected = true;
    put(std::move(resumed), PlayerEventKind::resumed);
}

void Players::disconnect(ClientId client) {
    const Player* const known = find(client);
    if (!known || !known->connected) return;
    Player disconnected = *known;
    disconnected.connected = false;
    put(std::move(disconnected), PlayerEventKind::disconnected);
}

bool Players::leave(ClientId client) {
    const auto at = players_.find(client);
    if (at == players_.end()) return false;
    events_.push_back({0, PlayerEventKind::left, std::move(at->second)});
    players_.erase(at);
    changed_ = true;
    return true;
}

Status Players::rename(ClientId client, const std::string& name) {
    const Player* const known = find(client);
    if (!known) return no_such_player(client);
    if (known->name == name) return {};
    Player renamed = *known;
    renamed.name = name;
    put(std::move(renamed), PlayerEventKind::renamed);
    return {};
}

Status Players::set_role(ClientId client, PlayerRole role) {
    const Player* const known = find(client);
    if (!known) return no_such_player(client);
    if (known->role == role) return {};
    Player changed = *known;
    changed.role = role;
    put(std::move(changed), PlayerEventKind::role_changed);
    return {};
}

const Player* Players::find(ClientId client) const {
    const auto at = players_.find(client);
    return at == players_.end() ? nullptr : at->second.get();
}

PlayerRole Players::role_of(ClientId client) const {
    const Player* const player = find(client);
    return player ? player->role : PlayerRole::unspecified;
}

const PlayerListPtr& Players::publish(std::uint32_t tick) {
    if (!changed_) return list_;
    auto list = std::make_shared<PlayerList>();
    list->revision = list_->revision + static_cast<std::uint32_t>(events_.size());
    list->players.reserve(players_.size());
    for (const auto& [client, player] : players_) list->players.push_back(player);
    const std::size_t retained =
        std::min(list_->recent.size(),
                 PlayerList::recent_max - std::min(PlayerList::recent_max, events_.size()));
    list->recent.assign(list_->recent.end() - static_cast<std::ptrdiff_t>(retained),
                        list_->recent.end());
    const std::size_t dropped = events_.size() - std::min(PlayerList::recent_max, events_.size());
    for (std::size_t k = dropped; k < events_.size(); k++) {
        events_[k].tick = tick;
        list->recent.push_back(std::move(events_[k]));
    }
    ASSERT(list->recent.size() <= PlayerList::recent_max);
    list_ = std::move(list);
    events_.clear();
    changed_ = false;
    return list_;
}

void Players::write(SavedHostState& host_state) const {
    for (const auto& [client, player] : players_)
        host_state.players.push_back({.client = client,
                                      .name = player->name,
                                      .role = static_cast<std::uint32_t>(player->role),
                                      .color = player->color,
                                      .connected = player->connected ? 1u : 0u,
                                      .joined_tick = player->joined_tick});
}

void Players::restore(const SavedHostState& host_state) {
    ASSERT(players_.empty());
    for (const SavedHostState::SavedPlayer& saved : host_state.players)
        players_[saved.client] =
            std::make_shared<const Player>(Player{.client = saved.client,
                                                  .name = saved.name,
                                                  .role = static_cast<PlayerRole>(saved.role),
                                                  .color = saved.color,
                                                  .connected = saved.connected != 0,
                                                  .joined_tick = saved.joined_tick});
    changed_ = !players_.empty();
}

Status check_player_name(const std::string& name, const std::string& where) {
    if (name.empty() || name.size() > player_name_bytes_max)
        return invalid_argument(where + " has " + std::to_string(name.size()) +
                                " bytes; it must have 1 to " +
                                std::to_string(player_name_bytes_max));
    if (has_control_character(name))
        return invalid_argument(where +
                                " contains a control character or invalid UTF-8; write a name "
                                "of printable characters");
    return {};
}

}  // namespace jostle::server
