// SPDX-License-Identifier: MIT
//
// A hosted world: applies each input at most once and produces frames, events and query frames.
// Owned by one thread (world/world_host).
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "jostle/base/result.h"
#include "jostle/scenes/scene.h"
#include "server/world/apply_action.h"
#include "server/world/command.h"
#include "server/world/export_scene.h"
#include "server/world/frame.h"
#include "server/world/inspection.h"
#include "server/world/joint_list.h"
#include "server/world/module_channels.h"
#include "server/world/query_frame.h"
#include "server/world/room.h"
#include "server/world/saved_host_state.h"

namespace jostle::server {

class HostedWorld {
public:
    // resource_exhausted: the scene costs more than the limits allow.
    static Result<HostedWorld> create(const scenes::SceneDescription& scene,
                                      const HostLimits& limits, int threads);

    // A world that continues bit-identically to the saved one; `world` holds its bodies.
    // corrupt_data: the host state does not match the world.
    static Result<HostedWorld> restore(physics::World world, const SavedHostState& host_state,
                                       const HostLimits& limits, double hz, double work_per_second);
    // The state beyond the bodies after `tick`, the last step.
    SavedHostState host_state(std::uint32_t tick) const;

    // From now on the world is a room, or is none. Before its first tick in this process.
    void set_room(std::optional<RoomState> room);
    // Null: the world is no room.
    const Room* room() const { return room_.get(); }
    // Whether the client may send messages to other clients now (Room::may_send_message()). A world
    // without a room does not restrict messages.
    Status may_send_message(ClientId client) const {
        return room_ ? room_->may_send_message(client) : Status();
    }
    // Applies a decision of the host, which the rules of the room do not restrict, and journals it.
    // failed_precondition: the world is no room.
    Status apply_to_room(RoomCommand command);
    Room::Requests take_room_requests() {
        return room_ ? room_->take_requests() : Room::Requests();
    }

    // Replaces `later`, a later state of the same world: keeps its sequence numbers and the
    // decisions of its room, and never assigns its entity ids again.
    void continue_from(const HostedWorld& later);
    // Removes all clients and retains their bodies.
    void release_all_clients();
    // Before its first tick in this process.
    void set_limits(const HostLimits& limits);

    // Applies an input at most once: refuses a sequence that does not exceed the client's last one.
    InputResult apply(const Command& command, std::uint32_t tick);
    // The input is not applied for `reason`, which is its result. Its sequence number counts, so
    // that it is not applied later either.
    InputResult refuse(const Command& command, Status reason, std::uint32_t tick);
    // Removes entities, whoever owns them; unknown ones are skipped.
    void remove_entities(std::span<const EntityId> entities);
    // Removes the bodies that the client spawned and returns their number.
    std::size_t remove_bodies_of(ClientId client);
    // Applies an action of the server between two ticks or before a step; it is recorded like an
    // input. For embedders and administrators: attributes, roles, messages.
    Status apply_as_server(const Action& action);
    // Likewise, for a client or the server. Sets the entity and the joint of the result, also on
    // error.
    Status apply_between_inputs(ClientId client, const Action& action, InputResult& result);
    // apply(), refuse(), apply_as_server() and remove_entities() record commands for take_journal()
    // from now on.
    void enable_journal() { journal_enabled_ = true; }
    // Returns the commands that were applied since the previous call.
    std::vector<JournaledCommand> take_journal() { return std::exchange(journal_, {}); }
    // Repeats a recorded apply() on a world with the state of that time, and returns the affected
    // entity (0: none). `spawned`: the id of a spawned entity; 0: the next one.
    EntityId replay(const JournaledCommand& command, EntityId spawned = 0);
    // Leaves a gap of `count` ids before the next entity.
    void skip_ids(std::uint32_t count) {
        state_.entities.set_next_id(state_.entities.next_id() + count);
    }
    // Steps the world and publishes the module channels of `tick`, which starts at 1. aborted:
    // stop_stepping() was called.
    Status step(double dt, std::uint32_t tick = 1);
    // Whether frames carry the velocities of bodies (module_channels.h).
    void publish_motion(bool wanted) { channels_.publish_motion(wanted); }
    // Whether frames carry point objects.
    void publish_points(bool wanted) { channels_.publish_points(wanted); }
    // Whether frames carry the list of joints.
    void publish_joints(bool wanted) { publishes_joints_ = wanted; }
    // Whether frames carry the states of controlled entities.
    void publish_controlled_entities(bool wanted) { publishes_controlled_entities_ = wanted; }
    // Any thread: physics::World::stop_stepping().
    void stop_stepping() { state_.world.stop_stepping(); }
    void resume_stepping() { state_.world.resume_stepping(); }
    // Fills the fields of a frame that depend on the world; WorldHost adds times. `frame.tick` must
    // be set.
    void copy_into(Frame& frame);
    // The events of the last step; nothing if there were none. Before the next command.
    std::optional<TickEvents> events_of_step(std::uint32_t tick) const;
    // Entities whose state became non-finite in the last step, each reported once.
    std::vector<std::shared_ptr<const EntityDescription>> newly_quarantined();
    // The channels of modules; constant.
    const std::vector<physics::ChannelKind>& channel_kinds() const { return channels_.kinds(); }
    // Kinds whose channels of the last step exceeded a limit, each reported once.
    const std::vector<ModuleChannels::OversizedChannel>& newly_oversized() const {
        return channels_.newly_oversized();
    }
    QueryFramePtr query_frame(std::uint32_t tick, CopyLayers layers);
    // The state of one entity or joint; `joint`: as clients name it. not_found: there is none.
    Result<BodyInspection> inspect_entity(EntityId entity);
    Result<JointInspection> inspect_joint(std::uint32_t joint);
    // The current state; `origin` is the scene from which the world was created.
    ExportedScene exported(const scenes::SceneDescription& origin) {
        return export_scene(state_, origin, ids_);
    }

    const physics::World& world() const { return state_.world; }
    const Ownership& ownership() const { return state_.ownership; }
    const Players& players() const { return state_.players; }
    const Attributes& attributes() const { return state_.attributes; }
    // The newest user messages, also those to the server alone, as of the last copy_into().
    const RecentMessagesPtr& messages() const { return published_messages_; }
    // Number of user messages that were sent in this world.
    std::uint32_t message_count() const { return state_.messages.count(); }
    // A hash of the players and attributes. The bodies have a hash of their own
    // (physics::state_hash).
    std::uint64_t data_hash() const;
    std::size_t entities() const { return state_.entities.size(); }
    // The newest frames, for lag compensation. Any thread.
    FrameRing& frame_history() const { return *frame_history_; }
    // The estimate of its creation (scene_budget.h).
    double work_per_second() const { return work_per_second_; }

private:
    void copy_points_into(QueryFrame& frame) const;
    HostedWorld(HostedState state, double hz)
        : state_(std::move(state)),
          hz_(hz),
          frame_history_(std::make_shared<FrameRing>(state_.limits.lag_compensation_ms_max, hz)) {}
    Status limit_pairs();
    Status apply_and_record(const Command& command, InputResult& result);
    // By the rules of the room, if the world is one.
    Status apply_by_rules(ClientId client, const Action& action, Affected& affected) {
        return room_ ? room_->apply(state_, client, action, affected)
                     : apply_action(state_, client, action, affected);
    }
    Status accept_sequence(ClientId client, std::uint32_t sequence);
    void copy_data_into(Frame& frame);
    // `all`: every pose; otherwise those of bodies that are or were awake.
    void copy_poses(bool all);

    HostedState state_;
    double hz_;
    std::shared_ptr<FrameRing> frame_history_;  // never null
    std::unique_ptr<Room> room_;                // null: the world is no room
    SceneIds ids_;
    double work_per_second_ = 0;
    ModuleChannels channels_;
    bool publishes_controlled_entities_ = false;
    bool publishes_joints_ = false;
    JointRegistry joints_;
    std::map<ClientId, std::uint32_t> last_sequences_;  // of the inputs of each client
    std::set<EntityId> quarantined_;                    // reported
    bool journal_enabled_ = false;
    std::vector<JournaledCommand> journal_;

    std::vector<physics::BodyState> bodies_;  // reused from tick to tick
    // State of the last frame.
    PoseEditor poses_;
    std::vector<std::size_t> index_of_body_;  // index in the entity list, by index of the body
    std::vector<physics::BodyId> awake_;
    std::uint64_t static_revision_ = 0;
    std::shared_ptr<const EntityList> entity_list_;
    std::shared_ptr<const Channels> published_channels_;
    std::shared_ptr<const PointObjects> published_points_;
    PlayerListPtr published_players_;
    AttributeTablePtr published_attributes_;
    RecentMessagesPtr published_messages_ = std::make_shared<const RecentMessages>();
    std::uint32_t changed_at_ = 0;
};

}  // namespace jostle::server
