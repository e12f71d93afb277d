// SPDX-License-Identifier: MIT
#include "server/world/room.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <variant>

#include "jostle/base/check.h"
#include "server/util/text.h"
#include "server/world/action_target.h"

namespace jostle::server {

using namespace physics;

namespace {

constexpr std::size_t bans_max = 1000, grants_max = 1000;
// Buckets hold the energy of this time, and the explosions of this one.
constexpr double energy_seconds = 2, explosion_seconds = 10;
constexpr double vote_seconds = 60;         // until a vote ends without a result
constexpr double vote_pause_seconds = 120;  // between two votes that a client begins
constexpr double vote_ban_seconds = 300;
constexpr std::size_t votes_min = 2;

Error denied(std::string message) {
    return {ErrorCode::permission_denied, std::move(message)};
}

Error no_such_client(ClientId client) {
    return {ErrorCode::not_found, fmt::format("client {} is not in the room", client)};
}

std::string_view describe(TargetOwner owner) {
    switch (owner) {
        case TargetOwner::self:
            return " an own entity";
        case TargetOwner::scene:
            return " an entity of the scene";
        case TargetOwner::other:
            return " an entity of another client";
        case TargetOwner::no_target:
            break;
    }
    return "";
}

double explosions_max(const RoleQuotas& quotas) {
    return std::max(1.0, quotas.explosions_per_minute * explosion_seconds / 60);
}

}  // namespace

RoomState new_room(RoomProperties properties, const std::string& owner) {
    RoomState state{.properties = std::move(properties)};
    if (!owner.empty()) state.owner = std::string(subject_member) + owner;
    return state;
}

// --- actions ---

Status Room::apply(HostedState& world, ClientId client, const Action& action, Affected& affected) {
    const Status done = apply_by_rules(world, client, action, affected);
    if (std::exchange(has_new_roles_, false)) publish_roles(world);
    return done;
}

void Room::publish_roles(HostedState& world) {
    for (const RoomClient& client : state_.clients) {
        const PlayerRole listed = world.players.role_of(client.client);
        if (listed == PlayerRole::unspecified || listed == client.role) continue;
        const Status changed = world.players.set_role(client.client, client.role);
        ASSERT(changed.ok());
    }
}

Status Room::apply_by_rules(HostedState& world, ClientId client, const Action& action,
                            Affected& affected) {
    if (const auto* role = std::get_if<SetRoleCommand>(&action))
        return apply(world, client, RoomCommand{SetRole{role->player, role->role}});
    if (const auto* join = std::get_if<JoinCommand>(&action)) {
        JoinCommand joined = *join;
        if (const RoomClient* const entry = state_.find(client)) joined.role = entry->role;
        return apply_action(world, client, joined, affected);
    }
    if (client != scene_client && is_data_command(action)) {
        if (const Result<RoomClient*> found = present(client); !found.ok()) return found.error();
        const auto* const message = std::get_if<SendMessageCommand>(&action);
        if (message && !message->to_server)
            if (Status s = may_send_message(client); !s.ok()) return s;
        return apply_action(world, client, action, affected);
    }
    if (const auto* command = std::get_if<RoomCommand>(&action))
        return apply(world, client, *command);
    if (std::holds_alternative<LeaveCommand>(action)) {
        const Status done = apply_action(world, client, action, affected);
        leave(client);
        return done;
    }
    if (client == scene_client || !target_of(world, client, action))
        return apply_action(world, client, action, affected);
    const Result<RoomClient*> found = present(client);
    if (!found.ok()) return found.error();
    RoomClient& by = **found;
    if (Status s = check(world, by, action); !s.ok()) return s;
    if (Status s = check_areas(world, by, action); !s.ok()) return s;
    if (Status s = check_quotas(world, by, action); !s.ok()) return s;
    // The table replaces the rule that clients change only their own bodies.
    const Status done = apply_action(world, client, action, affected, Reachable::any);
    if (done.ok()) charge(world, by, action, affected.entity);
    return done;
}

Result<RoomClient*> Room::present(ClientId client) {
    RoomClient* const found = state_.find(client);
    if (!found) return denied("the client has not entered the room");
    if (found->removed)
        return denied("the client was removed from the room: " + found->removed_reason);
    return found;
}

Status Room::may(ClientId client, RoomAction action) const {
    const RoomClient* const found = state_.find(client);
    if (!found || found->removed) return denied("the client is not in the room");
    if (state_.properties.permissions.allows(found->role, action, TargetOwner::no_target))
        return {};
    return denied(fmt::format("room.permissions: {0}.{1} is none; the role {0} may not {1}",
                              name_of(found->role), name_of(action)));
}

Status Room::may_send_message(ClientId client) const {
    if (Status s = may(client, RoomAction::message); !s.ok()) return s;
    const std::uint64_t until = state_.find(client)->muted_until;
    if (until <= state_.step) return {};
    const int ms = ms_until(until);
    return Error{ErrorCode::resource_exhausted,
                 fmt::format("the client is muted; retry in {:.1f} s", ms / 1000.0), ms};
}

Status Room::check(const HostedState& world, const RoomClient& client, const Action& action) const {
    const ActionTarget target = *target_of(world, client.client, action);
    const PermissionTable& table = state_.properties.permissions;
    if (table.allows(client.role, target.action, target.owner)) return {};
    return denied(fmt::format("room.permissions: {0}.{1} is {2}; the role {0} may not {1}{3}",
                              name_of(client.role), name_of(target.action),
                              name_of(table.of(client.role, target.action)),
                              describe(target.owner)));
}

Status Room::check_areas(const HostedState& world, const RoomClient& client,
                         const Action& action) const {
    if (state_.properties.areas.empty()) return {};
    const ActionTarget target = *target_of(world, client.client, action);
    if (!target.point) return {};
    for (const ProtectedArea& area : state_.properties.areas)
        if (client.role < area.min_role &&
            (area.contains(*target.point, target.radius) ||
             (target.second_point && area.contains(*target.second_point))))
            return denied(
                fmt::format("the area {} is protected: it requires the role {}, and the "
                            "client has the role {}",
                            quoted(area.name), name_of(area.min_role), name_of(client.role)));
    return {};
}

Status Room::check_counts(const HostedState& world, const RoomClient& client,
                          const Action& action) const {
    const RoleQuotas& quotas = state_.properties.quotas_of(client.role);
    const auto refused = [&](std::string_view quota, std::size_t owned, std::uint32_t limit) {
        return Error{ErrorCode::resource_exhausted,
                     fmt::format("the client owns {0} {1}; room.quotas: {2}.{1} allows {3}; delete "
                                 "a {4} first",
                                 owned, quota, name_of(client.role), limit,
                                 quota == "bodies" ? "body" : "joint")};
    };
    const AddedObjects added = added_objects(world, client.client, action);
    const auto bodies = static_cast<std::size_t>(world.ownership.count(client.client));
    if (quotas.bodies > 0 && added.bodies > 0 && bodies + added.bodies > quotas.bodies)
        return refused("bodies", bodies, quotas.bodies);
    if (quotas.joints == 0 || added.joints == 0) return {};
    const auto joints =
        static_cast<std::size_t>(world.joint_owners.count(world.world, client.client));
    if (joints + added.joints > quotas.joints) return refused("joints", joints, quotas.joints);
    return {};
}

Status Room::check_quotas(const HostedState& world, RoomClient& client,
                          const Action& action) const {
    if (Status s = check_counts(world, client, action); !s.ok()) return s;
    const RoleQuotas& quotas = state_.properties.quotas_of(client.role);
    const auto refused = [&](std::string_view quota, double limit, double seconds) {
        const int ms = static_cast<int>(std::ceil(1000 * (seconds + 1 / hz_)));
        return Error{ErrorCode::resource_exhausted,
                     fmt::format("room.quotas: {}.{} is {:g}; retry in {:.1f} s",
                                 name_of(client.role), quota, limit, ms / 1000.0),
                     ms};
    };
    if (quotas.energy_per_second > 0 && needs_energy(action)) {
        refill(client.energy, quotas.energy_per_second, energy_seconds * quotas.energy_per_second);
        if (client.energy.level <= 0)
            return refused("energy_per_second", quotas.energy_per_second,
                           -client.energy.level / quotas.energy_per_second);
    }
    if (quotas.explosions_per_minute > 0 && std::holds_alternative<ExplodeCommand>(action)) {
        const double per_second = quotas.explosions_per_minute / 60;
        refill(client.explosions, per_second, explosions_max(quotas));
        if (client.explosions.level < 1)
            return refused("explosions_per_minute", quotas.explosions_per_minute,
                           (1 - client.explosions.level) / per_second);
    }
    return {};
}

void Room::charge(const HostedState& world, RoomClient& client, const Action& action,
                  EntityId affected) const {
    const RoleQuotas& quotas = state_.properties.quotas_of(client.role);
    if (quotas.energy_per_second > 0) client.energy.level -= energy_of(world, action, affected);
    if (quotas.explosions_per_minute > 0 && std::holds_alternative<ExplodeCommand>(action))
        client.explosions.level -= 1;
}

void Room::refill(RoomBucket& bucket, double per_second, double level_max) const {
    ASSERT(bucket.step <= state_.step);
    const double seconds = static_cast<double>(state_.step - bucket.step) / hz_;
    bucket.level = std::min(bucket.level + seconds * per_second, level_max);
    bucket.step = state_.step;
}

void Room::on_step() {
    const std::uint64_t now = ++state_.step;
    const std::size_t ended = std::erase_if(
        state_.bans, [&](const RoomBan& ban) { return ban.until != 0 && ban.until <= now; });
    bool changed = ended > 0;
    for (RoomClient& client : state_.clients)
        if (client.muted_until != 0 && client.muted_until <= now) {
            client.muted_until = 0;
            changed = true;
        }
    if (state_.vote && state_.vote->until <= now) {
        state_.vote.reset();
        changed = true;
    }
    if (changed) view_ = nullptr;
}

const RoomView& Room::view() {
    if (view_) return view_;
    view_ = std::make_shared<const RoomState>(state_);
    return view_;
}

// --- members ---

void Room::enter(ClientId client, const EnterRoom& c) {
    ASSERT(client != scene_client);
    view_ = nullptr;
    RoomClient* entry = state_.find(client);
    const bool is_new = entry == nullptr;
    if (is_new) {
        const auto at = std::ranges::upper_bound(state_.clients, client, {}, &RoomClient::client);
        entry =
            &*state_.clients.insert(at, RoomClient{.client = client, .entered = ++state_.entered});
    }
    const bool keeps_role = !is_new && entry->spectator == c.spectator;
    entry->member = c.member;
    entry->spectator = c.spectator;
    if (!keeps_role) {
        const auto granted = std::ranges::find(state_.grants, c.member, &RoomGrant::member);
        if (c.spectator)
            set_role(*entry, PlayerRole::spectator);
        else if (c.admin || (!state_.owner.empty() && c.member == state_.owner))
            set_role(*entry, PlayerRole::owner);
        else
            set_role(*entry, granted != state_.grants.end() ? granted->role
                                                            : state_.properties.initial_role);
    }
    if (const RoomBan* const banned = state_.ban_of(c.member);
        banned && entry->role != PlayerRole::owner)
        remove(*entry, banned->reason);
    promote_successor();
}

// With full buckets: a role without quotas has empty ones.
void Room::set_role(RoomClient& client, PlayerRole role) {
    const RoleQuotas& quotas = state_.properties.quotas_of(role);
    client.role = role;
    has_new_roles_ = true;
    client.energy = {energy_seconds * quotas.energy_per_second, state_.step};
    client.explosions = {explosions_max(quotas), state_.step};
    view_ = nullptr;
}

void Room::leave(ClientId client) {
    if (std::erase_if(state_.clients,
                      [&](const RoomClient& one) { return one.client == client; }) == 0)
        return;
    view_ = nullptr;
    if (state_.vote) {
        if (state_.vote->target == client)
            state_.vote.reset();
        else
            std::erase(state_.vote->clients, client);
    }
    count_votes();
    promote_successor();
}

void Room::promote_successor() {
    if (!state_.owner.empty()) return;
    RoomClient* successor = nullptr;
    for (RoomClient& client : state_.clients) {
        if (client.removed || client.role < PlayerRole::player) continue;
        if (client.role == PlayerRole::owner) return;
        if (!successor || client.entered < successor->entered) successor = &client;
    }
    if (!successor) return;
    set_role(*successor, PlayerRole::owner);
}

Result<RoomClient*> Room::subordinate(const RoomClient* by, RoomAction action, ClientId client) {
    if (by)
        if (Status s = may(by->client, action); !s.ok()) return s.error();
    RoomClient* const target = state_.find(client);
    if (!target) return no_such_client(client);
    if (by && target->role >= by->role)
        return denied(fmt::format("client {} has the role {}; the role {} may not {} it", client,
                                  name_of(target->role), name_of(by->role), name_of(action)));
    return target;
}

void Room::remove(RoomClient& client, std::string reason) {
    if (client.removed) return;
    client.removed = true;
    client.removed_reason = reason.empty() ? "no reason given" : std::move(reason);
    view_ = nullptr;
    if (state_.vote && state_.vote->target == client.client) state_.vote.reset();
}

void Room::ban(const std::string& member, double seconds, const std::string& reason) {
    std::erase_if(state_.bans, [&](const RoomBan& ban) { return ban.member == member; });
    state_.bans.push_back({.member = member,
                           .until = seconds > 0 ? state_.step + steps_of(seconds) : 0,
                           .reason = reason});
    for (RoomClient& client : state_.clients)
        if (client.member == member && client.role != PlayerRole::owner) remove(client, reason);
}

void Room::grant(const std::string& member, PlayerRole role) {
    if (!member.starts_with(subject_member)) return;
    std::erase_if(state_.grants, [&](const RoomGrant& grant) { return grant.member == member; });
    if (state_.grants.size() >= grants_max) state_.grants.erase(state_.grants.begin());
    state_.grants.push_back({member, role});
}

std::uint64_t Room::steps_of(double seconds) const {
    return static_cast<std::uint64_t>(std::ceil(seconds * hz_));
}

int Room::ms_until(std::uint64_t step) const {
    const double ms = step > state_.step ? 1000 * static_cast<double>(step - state_.step) / hz_ : 0;
    return static_cast<int>(std::min(std::ceil(ms), 2e9));
}

// --- commands ---

Status Room::apply(HostedState& world, ClientId client, const RoomCommand& command) {
    if (const auto* entry = std::get_if<EnterRoom>(&command.kind)) {
        enter(client, *entry);
        return {};
    }
    RoomClient* by = nullptr;
    if (client != scene_client) {
        const Result<RoomClient*> found = present(client);
        if (!found.ok()) return found.error();
        by = *found;
    }
    const Status done =
        std::visit([&](const auto& kind) { return apply(world, by, kind); }, command.kind);
    if (done.ok()) view_ = nullptr;
    return done;
}

Status Room::apply(HostedState&, RoomClient*, const EnterRoom&) const {
    return {};
}

Status Room::apply(HostedState&, RoomClient* by, const SetRole& c) {
    const Result<RoomClient*> found = subordinate(by, RoomAction::set_role, c.client);
    if (!found.ok()) return found.error();
    RoomClient& target = **found;
    const bool transfers = c.role == PlayerRole::owner;
    if (c.role == PlayerRole::unspecified)
        return invalid_argument(
            "set_role.role is missing; use spectator, player, builder or owner");
    if (by && (transfers ? by->role != PlayerRole::owner : c.role >= by->role))
        return denied(fmt::format("the role {} may not give the role {}", name_of(by->role),
                                  name_of(c.role)));
    if (target.spectator && c.role != PlayerRole::spectator)
        return Error{ErrorCode::permission_denied,
                     fmt::format("client {} joined as a spectator; it must join again as a player",
                                 c.client)};
    if (transfers) {
        for (RoomClient& client : state_.clients)
            if (client.role == PlayerRole::owner) set_role(client, PlayerRole::builder);
        grant(state_.owner, PlayerRole::builder);
        state_.owner = target.member.starts_with(subject_member) ? target.member : std::string();
    }
    set_role(target, c.role);
    grant(target.member, transfers ? PlayerRole::builder : c.role);
    return {};
}

Status Room::apply(HostedState&, RoomClient* by, const KickClient& c) {
    const Result<RoomClient*> target = subordinate(by, RoomAction::kick, c.client);
    if (!target.ok()) return target.error();
    remove(**target, c.reason);
    promote_successor();
    return {};
}

Status Room::apply(HostedState&, RoomClient* by, const BanClient& c) {
    const Result<RoomClient*> target = subordinate(by, RoomAction::ban, c.client);
    if (!target.ok()) return target.error();
    if ((*target)->member.empty())
        return Error{ErrorCode::permission_denied,
                     fmt::format("client {} cannot be identified; kick it instead", c.client)};
    const std::string member = (*target)->member;
    if (by && by->member == member)
        return denied(
            fmt::format("client {} has the subject or network of the caller; kick it "
                        "instead",
                        c.client));
    if (state_.bans.size() >= bans_max)
        return Error{ErrorCode::resource_exhausted,
                     fmt::format("the room has {} bans, the maximum; remove one first", bans_max)};
    ban(member, c.seconds, c.reason);
    promote_successor();
    return {};
}

Status Room::apply(HostedState&, RoomClient* by, const UnbanMember& c) {
    if (by)
        if (Status s = may(by->client, RoomAction::ban); !s.ok()) return s;
    const std::size_t removed =
        std::erase_if(state_.bans, [&](const RoomBan& ban) { return ban.member == c.member; });
    if (removed > 0) return {};
    return Error{ErrorCode::not_found, "the room has no ban of " + quoted(c.member)};
}

Status Room::apply(HostedState&, RoomClient* by, const MuteClient& c) {
    const Result<RoomClient*> target = subordinate(by, RoomAction::mute, c.client);
    if (!target.ok()) return target.error();
    (*target)->muted_until = c.seconds > 0 ? state_.step + steps_of(c.seconds) : 0;
    return {};
}

Status Room::apply(HostedState& world, RoomClient* by, const CleanUpBodies& c) {
    if (by && by->client != c.client) {
        const TargetOwner owner = TargetOwner::other;
        if (!state_.properties.permissions.allows(by->role, RoomAction::clean_up, owner))
            return denied(fmt::format(
                "room.permissions: {0}.clean_up is {1}; the role {0} may not clean_up{2}",
                name_of(by->role),
                name_of(state_.properties.permissions.of(by->role, RoomAction::clean_up)),
                describe(owner)));
        if (const RoomClient* const target = state_.find(c.client);
            target && target->role >= by->role)
            return denied(fmt::format("client {} has the role {}; the role {} may not clean_up it",
                                      c.client, name_of(target->role), name_of(by->role)));
    } else if (by) {
        if (Status s = may(by->client, RoomAction::clean_up); !s.ok()) return s;
    }
    if (c.client == scene_client)
        return invalid_argument("clean_up.client is 0; it must be the id of a client");
    std::vector<EntityId> bodies;
    for (const auto& [id, entity] : world.entities.all())
        if (entity.description->owner == c.client) bodies.push_back(id);
    Affected ignored;
    for (const EntityId id : bodies) {
        const Status removed = apply_action(world, scene_client, DeleteCommand{id}, ignored);
        ASSERT(removed.ok());
    }
    return {};
}

Status Room::apply(HostedState&, RoomClient* by, const ProtectArea& c) {
    if (by)
        if (Status s = may(by->client, RoomAction::protect); !s.ok()) return s;
    if (Status s = check_area(c.area); !s.ok()) return s;
    if (by && c.area.min_role > by->role)
        return denied(
            fmt::format("the role {} may not protect an area from itself", name_of(by->role)));
    std::vector<ProtectedArea>& areas = state_.properties.areas;
    const auto at = std::ranges::find(areas, c.area.name, &ProtectedArea::name);
    if (at != areas.end()) {
        if (by && by->role < at->min_role)
            return denied(fmt::format("the area {} requires the role {}", quoted(c.area.name),
                                      name_of(at->min_role)));
        *at = c.area;
        return {};
    }
    if (areas.size() >= RoomProperties::areas_max)
        return Error{
            ErrorCode::resource_exhausted,
            fmt::format("the room has {} areas, the maximum; remove one first", areas.size())};
    areas.push_back(c.area);
    return {};
}

Status Room::apply(HostedState&, RoomClient* by, const UnprotectArea& c) {
    if (by)
        if (Status s = may(by->client, RoomAction::protect); !s.ok()) return s;
    std::vector<ProtectedArea>& areas = state_.properties.areas;
    const auto at = std::ranges::find(areas, c.name, &ProtectedArea::name);
    if (at == areas.end())
        return Error{ErrorCode::not_found, "the room has no area " + quoted(c.name)};
    if (by && by->role < at->min_role)
        return denied(
            fmt::format("the area {} requires the role {}", quoted(c.name), name_of(at->min_role)));
    areas.erase(at);
    return {};
}

Status Room::apply(HostedState&, RoomClient* by, const VoteToKick& c) {
    if (!by) return invalid_argument("only clients vote; use kick");
    if (Status s = may(by->client, RoomAction::vote); !s.ok()) return s;
    const RoomClient* const target = state_.find(c.client);
    if (!target || target->removed) return no_such_client(c.client);
    if (target == by) return invalid_argument("vote_kick.client is the client itself");
    if (target->role == PlayerRole::owner)
        return denied("the owner of the room cannot be removed by a vote");
    if (state_.vote && state_.vote->target != c.client)
        return Error{ErrorCode::resource_exhausted,
                     fmt::format("a vote about client {} is in progress", state_.vote->target),
                     ms_until(state_.vote->until)};
    if (!state_.vote) {
        if (by->vote_after > state_.step) {
            const int ms = ms_until(by->vote_after);
            return Error{ErrorCode::resource_exhausted,
                         fmt::format("the client began a vote less than {:g} s ago; retry in "
                                     "{:.1f} s",
                                     vote_pause_seconds, ms / 1000.0),
                         ms};
        }
        by->vote_after = state_.step + steps_of(vote_pause_seconds);
        state_.vote = RoomVote{.target = c.client, .until = state_.step + steps_of(vote_seconds)};
    }
    std::vector<std::uint32_t>& votes = state_.vote->clients;
    if (std::ranges::find(votes, by->client) == votes.end()) votes.push_back(by->client);
    count_votes();
    return {};
}

// A vote succeeds with the votes of more than half of the other players.
void Room::count_votes() {
    if (!state_.vote) return;
    std::size_t others = 0;
    for (const RoomClient& client : state_.clients)
        if (!client.removed && client.role >= PlayerRole::player &&
            client.client != state_.vote->target)
            others++;
    const std::size_t votes = state_.vote->clients.size();
    if (votes < votes_min || 2 * votes <= others) return;
    RoomClient* const target = state_.find(state_.vote->target);
    ASSERT(target);
    const std::string reason = "removed by a vote of the players", member = target->member;
    state_.vote.reset();
    remove(*target, reason);
    // The voters may have the same network.
    if (member.starts_with(subject_member) && state_.bans.size() < bans_max)
        ban(member, vote_ban_seconds, reason);
    view_ = nullptr;
}

Status Room::apply(HostedState&, RoomClient* by, const PauseRoom& c) {
    if (by)
        if (Status s = may(by->client, RoomAction::pause); !s.ok()) return s;
    requests_.paused = c.paused;
    return {};
}

Status Room::apply(HostedState&, RoomClient* by, const ResetRoom&) {
    if (by)
        if (Status s = may(by->client, RoomAction::reset); !s.ok()) return s;
    requests_.reset = true;
    return {};
}

Status Room::apply(HostedState&, RoomClient* by, const StepRoom& c) {
    if (by)
        if (Status s = may(by->client, RoomAction::pause); !s.ok()) return s;
    requests_.steps += c.steps;
    return {};
}

Status Room::apply(HostedState&, RoomClient* by, const SetRoomSpeed& c) {
    if (by)
        if (Status s = may(by->client, RoomAction::speed); !s.ok()) return s;
    requests_.speed_percent = c.percent;
    return {};
}

Status Room::apply(HostedState&, RoomClient* by, const RewindRoom& c) {
    if (by)
        if (Status s = may(by->client, RoomAction::rewind); !s.ok()) return s;
    requests_.rewind = c.tick;
    return {};
}

// Roles, bans and the owner stay.
Status Room::apply(HostedState&, RoomClient* by, const UpdateRoom& c) {
    if (by)
        if (Status s = may(by->client, RoomAction::settings); !s.ok()) return s;
    if (Status s = check_properties(*c.properties); !s.ok()) return s;
    state_.properties = *c.properties;
    // Buckets of other quotas begin full.
    for (RoomClient& client : state_.clients) set_role(client, client.role);
    return {};
}

}  // namespace jostle::server
