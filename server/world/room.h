// SPDX-License-Identifier: MIT
//
// The rules of a room: the one place that decides whether an action of a client reaches
// apply_action.h, and that applies room commands. Owned by HostedWorld; one thread.
//
// A refusal names the rule: permission_denied for the table of permissions and protected areas,
// resource_exhausted with the time to retry for quotas.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "jostle/base/result.h"
#include "server/world/apply_action.h"
#include "server/world/command.h"
#include "server/world/room_state.h"

namespace jostle::server {

class Room {
public:
    // `hz`: steps per second.
    Room(RoomState state, double hz) : state_(std::move(state)), hz_(hz) {}

    // Applies an action if the rules allow it. Sets `affected` like apply_action().
    Status apply(HostedState& world, ClientId client, const Action& action, Affected& affected);
    // After each step of the world.
    void on_step();
    // Whether the client may send messages to other clients now. Errors: it is muted
    // (resource_exhausted, with the time to retry), its role may not, or it was kicked.
    Status may_send_message(ClientId client) const;
    // Whether the client may take an action without a target.
    Status may(ClientId client, RoomAction action) const;

    const RoomState& state() const { return state_; }
    // The same pointer until something in it changes.
    const RoomView& view();

    // Requests to the host of the world, once; they are not part of the state.
    struct Requests {
        std::optional<bool> paused = {};
        bool reset = false;
        std::uint32_t steps = 0;  // of a world that a member paused
        std::optional<std::uint32_t> speed_percent = {};
        std::optional<std::uint32_t> rewind = {};  // tick
    };
    Requests take_requests() { return std::exchange(requests_, {}); }

private:
    Result<RoomClient*> present(ClientId client);
    Status check(const HostedState& world, const RoomClient& client, const Action& action) const;
    Status check_areas(const HostedState& world, const RoomClient& client,
                       const Action& action) const;
    Status check_counts(const HostedState& world, const RoomClient& client,
                        const Action& action) const;
    Status check_quotas(const HostedState& world, RoomClient& client, const Action& action) const;
    void charge(const HostedState& world, RoomClient& client, const Action& action,
                EntityId affected) const;
    void refill(RoomBucket& bucket, double per_second, double level_max) const;

    Status apply(HostedState& world, ClientId client, const RoomCommand& command);
    // One overload per kind of command. `by`: null for the host, which may do everything.
    Status apply(HostedState&, RoomClient* by, const EnterRoom&) const;
    Status apply(HostedState&, RoomClient* by, const SetRole& c);
    Status apply(HostedState&, RoomClient* by, const KickClient& c);
    Status apply(HostedState&, RoomClient* by, const BanClient& c);
    Status apply(HostedState&, RoomClient* by, const UnbanMember& c);
    Status apply(HostedState&, RoomClient* by, const MuteClient& c);
    Status apply(HostedState& world, RoomClient* by, const CleanUpBodies& c);
    Status apply(HostedState&, RoomClient* by, const ProtectArea& c);
    Status apply(HostedState&, RoomClient* by, const UnprotectArea& c);
    Status apply(HostedState&, RoomClient* by, const VoteToKick& c);
    Status apply(HostedState&, RoomClient* by, const PauseRoom& c);
    Status apply(HostedState&, RoomClient* by, const ResetRoom&);
    Status apply(HostedState&, RoomClient* by, const UpdateRoom& c);
    Status apply(HostedState&, RoomClient* by, const StepRoom& c);
    Status apply(HostedState&, RoomClient* by, const SetRoomSpeed& c);
    Status apply(HostedState&, RoomClient* by, const RewindRoom& c);

    void enter(ClientId client, const EnterRoom& c);
    void leave(ClientId client);
    void set_role(RoomClient& client, PlayerRole role);
    // The list of players has the roles of the room.
    void publish_roles(HostedState& world);
    Status apply_by_rules(HostedState& world, ClientId client, const Action& action,
                          Affected& affected);
    // The client on which `by` may act: its own role must be higher.
    Result<RoomClient*> subordinate(const RoomClient* by, RoomAction action, ClientId client);
    void remove(RoomClient& client, std::string reason);
    void ban(const std::string& member, double seconds, const std::string& reason);
    void grant(const std::string& member, PlayerRole role);
    void promote_successor();
    void count_votes();
    std::uint64_t steps_of(double seconds) const;
    int ms_until(std::uint64_t step) const;

    RoomState state_;
    double hz_;
    Requests requests_;
    bool has_new_roles_ = false;  // within apply()
    RoomView view_;               // null: changed since the last view()
};

// The state of a new room. `owner`: the subject of its creator; empty: none.
RoomState new_room(RoomProperties properties, const std::string& owner);

}  // namespace jostle::server
