// SPDX-License-Identifier: MIT
#include "server/world/hosted_world.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "jostle/base/check.h"
#include "server/world/resolve_target.h"
#include "server/world/sync_module_entities.h"

namespace jostle::server {

using namespace physics;

Result<HostedWorld> HostedWorld::create(const scenes::SceneDescription& scene,
                                        const HostLimits& limits, int threads) {
    if (Status s = check_description(scene, limits.scene); !s.ok()) return s.error();
    if (scene.modules.size() > scenes::modules_max)  // a limit of the protocol
        return Error{ErrorCode::invalid_argument, "the scene has " +
                                                      std::to_string(scene.modules.size()) +
                                                      " modules; a hosted world may have at most " +
                                                      std::to_string(scenes::modules_max)};
    Result<scenes::BuiltScene> built = scenes::build_scene(scene);
    if (!built.ok()) return built.error();
    const Result<double> work = estimate_work(scene, built->world, limits.scene);
    if (!work.ok()) return work.error();
    // The check takes a step, so the hosted world is built again.
    if (Status s = check_first_step(scene, std::move(built->world), limits.scene); !s.ok())
        return s.error();
    built = scenes::build_scene(scene);
    if (!built.ok()) return built.error();
    if (Status s = built->world.set_threads(threads); !s.ok()) return s.error();
    HostedWorld hosted({.world = std::move(built->world), .limits = limits}, scene.hz);
    if (Status s = hosted.limit_pairs(); !s.ok()) return s.error();
    hosted.work_per_second_ = *work;
    for (std::size_t i = 0; i < built->bodies.size(); i++)
        hosted.state_.entities.add(hosted.state_.world, built->bodies[i], 0, scene.bodies[i].color,
                                   scene.bodies[i].name);
    ASSERT(built->bodies.size() == scene.bodies.size() &&
           built->joints.size() == scene.joints.size());
    hosted.ids_ = {std::move(built->bodies), std::move(built->joints)};
    sync_module_entities(hosted.state_, hosted.bodies_);
    Result<ModuleChannels> channels = ModuleChannels::of(hosted.state_.world);
    if (!channels.ok()) return channels.error();
    hosted.channels_ = *std::move(channels);
    return hosted;
}

Result<HostedWorld> HostedWorld::restore(World world, const SavedHostState& host_state,
                                         const HostLimits& limits, double hz,
                                         double work_per_second) {
    HostedWorld hosted({.world = std::move(world), .limits = limits}, hz);
    hosted.work_per_second_ = work_per_second;
    HostedState& state = hosted.state_;
    if (Status s = state.entities.restore(state.world, host_state); !s.ok()) return s.error();
    state.ownership.restore(host_state);
    state.grabs.restore(host_state);
    state.controllers.restore(host_state);
    state.players.restore(host_state);
    for (const SavedHostState::SavedAttribute& saved : host_state.attributes) {
        const auto& [kind, id] = saved.target;
        const bool exists = kind == AttributeTargetKind::entity ? state.entities.find(id) != nullptr
                            : kind == AttributeTargetKind::player
                                ? state.players.find(id) != nullptr
                                : id == 0;
        if (!exists)
            return Error{ErrorCode::corrupt_data, "corrupt host state: attribute \"" + saved.key +
                                                      "\" of " + describe(saved.target) +
                                                      ", which does not exist"};
    }
    if (Status s = state.attributes.restore(host_state); !s.ok()) return s.error();
    state.messages.set_count(host_state.messages);
    state.joint_owners.restore(host_state);
    std::map<ClientId, std::deque<UndoStep>> undo;
    for (const SavedHostState::ClientUndo& of : host_state.undo)
        undo[of.client] = {of.steps.begin(), of.steps.end()};
    state.undo.restore(std::move(undo));
    for (const SavedHostState::ProcessedInput& input : host_state.processed)
        hosted.last_sequences_[input.client] = input.sequence;
    hosted.quarantined_.insert(host_state.quarantined.begin(), host_state.quarantined.end());
    hosted.set_room(host_state.room);
    hosted.ids_ = {host_state.scene_bodies, host_state.scene_joints};
    // Only after recovery from a portable checkpoint: its modules created their bodies again.
    sync_module_entities(state, hosted.bodies_);
    Result<ModuleChannels> channels = ModuleChannels::of(state.world);
    if (!channels.ok()) return channels.error();
    hosted.channels_ = *std::move(channels);
    return hosted;
}

SavedHostState HostedWorld::host_state(std::uint32_t tick) const {
    SavedHostState host_state{.tick = tick,
                              .quarantined = {quarantined_.begin(), quarantined_.end()},
                              .scene_bodies = ids_.bodies,
                              .scene_joints = ids_.joints};
    state_.entities.write(host_state);
    state_.ownership.write(host_state);
    state_.grabs.write(host_state);
    state_.controllers.write(host_state);
    state_.players.write(host_state);
    state_.attributes.write(host_state);
    host_state.messages = state_.messages.count();
    state_.joint_owners.write(state_.world, host_state);
    for (const auto& [client, steps] : state_.undo.all())
        host_state.undo.push_back({client, {steps.begin(), steps.end()}});
    for (const auto& [client, sequence] : last_sequences_)
        host_state.processed.push_back({client, sequence});
    if (room_) host_state.room = room_->state();
    return host_state;
}

void HostedWorld::set_room(std::optional<RoomState> room) {
    room_ = room ? std::make_unique<Room>(*std::move(room), hz_) : nullptr;
}

Status HostedWorld::apply_to_room(RoomCommand command) {
    if (!room_)
        return Error{ErrorCode::failed_precondition,
                     "the world has no room; create it with room settings"};
    InputResult ignored;
    return apply_and_record({.client = scene_client, .action = std::move(command), .reply = {}},
                            ignored);
}

void HostedWorld::continue_from(const HostedWorld& later) {
    if (later.room_) set_room(later.room_->state());
    last_sequences_ = later.last_sequences_;
    state_.entities.skip_ids_of(later.state_.entities);
    state_.messages.set_count(std::max(state_.messages.count(), later.state_.messages.count()));
}

std::uint64_t HostedWorld::data_hash() const {
    return server::data_hash(host_state(0));
}

void HostedWorld::release_all_clients() {
    for (const auto& [client, sequence] : clients_of(host_state(0)))
        apply({.client = client, .action = LeaveCommand{.retain_bodies = true}, .reply = nullptr},
              0);
}

void HostedWorld::set_limits(const HostLimits& limits) {
    state_.limits = limits;
    const Status limited = limit_pairs();
    ASSERT(limited.ok());
    frame_history_ = std::make_shared<FrameRing>(limits.lag_compensation_ms_max, hz_);
}

Status HostedWorld::limit_pairs() {
    return state_.world.set_max_pairs_per_shape(state_.limits.scene.pairs_per_shape_max);
}

Status HostedWorld::accept_sequence(ClientId client, std::uint32_t sequence) {
    std::uint32_t& last = last_sequences_[client];
    if (sequence <= last)
        return Error{ErrorCode::invalid_argument, "input " + std::to_string(sequence) +
                                                      " is not greater than the client's last "
                                                      "input " +
                                                      std::to_string(last)};
    last = sequence;
    return {};
}

InputResult HostedWorld::apply(const Command& command, std::uint32_t tick) {
    InputResult result{.sequence = command.sequence, .tick = tick};
    const bool is_leave = std::holds_alternative<LeaveCommand>(command.action);
    if (!is_session_command(command.action))
        result.status = accept_sequence(command.client, command.sequence);
    if (result.status.ok()) result.status = apply_and_record(command, result);
    if (is_leave) last_sequences_.erase(command.client);
    return result;
}

InputResult HostedWorld::refuse(const Command& command, Status reason, std::uint32_t tick) {
    InputResult result{.sequence = command.sequence, .tick = tick};
    result.status = accept_sequence(command.client, command.sequence);
    if (!result.status.ok()) return result;
    if (journal_enabled_) journal_.push_back({command.client, command.sequence, std::nullopt});
    result.status = std::move(reason);
    return result;
}

// The journal also records refused actions, because they may have side effects.
Status HostedWorld::apply_and_record(const Command& command, InputResult& result) {
    Action resolved;
    const Action* action = &command.action;
    Status status;
    if (has_target(command.action)) {
        resolved = command.action;
        action = &resolved;
        status = resolve_target(state_, channels_, *frame_history_, *state_.entities.list(),
                                resolved, result);
    } else if (const auto* deletion = std::get_if<DeleteJointCommand>(&command.action);
               deletion && deletion->joint != 0) {
        // The ids of clients are not part of the state of the world.
        resolved = DeleteJointCommand{deletion->joint, joints_.find(deletion->joint)};
        action = &resolved;
    }
    if (journal_enabled_)
        journal_.push_back({command.client, command.sequence,
                            status.ok() ? std::optional(*action) : std::nullopt});
    if (!status.ok()) return status;
    Affected affected{.entity = result.entity};
    status = apply_by_rules(command.client, *action, affected);
    result.entity = affected.entity;
    if (!is_null(affected.joint)) result.joint = joints_.id_of(affected.joint);
    return status;
}

Result<BodyInspection> HostedWorld::inspect_entity(EntityId entity) {
    return inspect_body(state_, entity, [this](JointId joint) { return joints_.id_of(joint); });
}

Result<JointInspection> HostedWorld::inspect_joint(std::uint32_t joint) {
    const JointId id = joints_.find(joint);
    if (!state_.world.contains(id))
        return Error{ErrorCode::not_found, "joint " + std::to_string(joint) + " does not exist"};
    return server::inspect_joint(state_, id,
                                 [this](JointId known) { return joints_.id_of(known); });
}

Status HostedWorld::apply_as_server(const Action& action) {
    InputResult result;
    return apply_between_inputs(scene_client, action, result);
}

Status HostedWorld::apply_between_inputs(ClientId client, const Action& action,
                                         InputResult& result) {
    return apply_and_record({.client = client, .action = action, .reply = {}}, result);
}

void HostedWorld::remove_entities(std::span<const EntityId> entities) {
    InputResult ignored;
    for (const EntityId entity : entities)
        if (state_.entities.find(entity))
            apply_and_record({.client = scene_client, .action = DeleteCommand{entity}, .reply = {}},
                             ignored)
                .expect();
}

std::size_t HostedWorld::remove_bodies_of(ClientId client) {
    std::vector<EntityId> bodies;
    for (const auto& entity : *state_.entities.list())
        if (entity->owner == client) bodies.push_back(entity->id);
    remove_entities(bodies);
    return bodies.size();
}

EntityId HostedWorld::replay(const JournaledCommand& command, EntityId spawned) {
    const bool has = command.action.has_value();
    const bool is_leave = has && std::holds_alternative<LeaveCommand>(*command.action);
    if (is_leave)
        last_sequences_.erase(command.client);
    else if (command.sequence != 0)
        last_sequences_[command.client] = command.sequence;
    Affected affected;
    if (!has) return 0;
    EntityRegistry& entities = state_.entities;
    const EntityId next = entities.next_id();
    const bool has_id = spawned != 0 && !entities.find(spawned);
    if (has_id) entities.set_next_id(spawned);
    static_cast<void>(apply_by_rules(command.client, *command.action, affected).ok());
    if (has_id) entities.set_next_id(std::max(next, entities.next_id()));
    return affected.entity;
}

Status HostedWorld::step(double dt, std::uint32_t tick) {
    ASSERT(dt > 0 && tick > 0);
    if (room_) room_->on_step();
    Status stepped = state_.world.step(dt);
    if (!stepped.ok()) return stepped;
    sync_module_entities(state_, bodies_);
    state_.entities.on_step();
    channels_.publish(state_.world, tick,
                      [this](BodyId body) { return state_.entities.find_living(body); });
    return {};
}

std::optional<TickEvents> HostedWorld::events_of_step(std::uint32_t tick) const {
    return copy_events(state_.world.events(), tick,
                       [this](BodyId body) { return state_.entities.entity_of(body); });
}

std::vector<std::shared_ptr<const EntityDescription>> HostedWorld::newly_quarantined() {
    std::vector<std::shared_ptr<const EntityDescription>> added;
    for (const BodyId body : state_.world.events().quarantined) {
        const EntityId id = state_.entities.entity_of(body);
        const Entity* const entity = state_.entities.find(id);
        if (!entity) continue;  // a module destroyed the body in the same step
        if (quarantined_.insert(id).second) added.push_back(entity->description);
    }
    return added;
}

QueryFramePtr HostedWorld::query_frame(std::uint32_t tick, CopyLayers layers) {
    auto frame = std::make_shared<QueryFrame>();
    frame->tick = tick;
    frame->layers = layers;
    frame->entity_list = state_.entities.list();
    frame->shape_owners = state_.entities.shape_owners();
    copy_layers(*frame, state_.world, state_.entities.by_body());
    // Points are published in steps.
    if (!channels_.publishes_points()) frame->layers &= ~copy_points;
    if (frame->layers & copy_points) copy_points_into(*frame);
    return frame;
}

void HostedWorld::copy_points_into(QueryFrame& frame) const {
    frame.points = channels_.points();
    std::set<EntityId> carriers;
    for (const auto& state : *frame.points) carriers.insert(state->object->entity);
    for (const EntityId id : carriers)
        if (const Entity* const entity = state_.entities.find(id); entity != nullptr)
            if (const auto body = state_.world.body(entity->body); body.ok())
                frame.carriers.push_back({id, body->awake, body->pose});
}

// A body that neither is awake nor was awake in the last frame has not moved, unless the static
// revision of the world changed.
void HostedWorld::copy_poses(bool all) {
    const World& world = state_.world;
    const auto& by_body = state_.entities.by_body();
    if (all) {
        std::vector<EntityPose> poses;
        world.copy_bodies(bodies_);
        poses.reserve(bodies_.size());
        for (const BodyState& body : bodies_)
            poses.push_back({by_body[body.id.index], body.awake, body.pose});
        // Bodies are listed by index; a reused index belongs to a later entity.
        std::ranges::sort(poses, {}, &EntityPose::id);
        ASSERT(poses.size() == state_.entities.size());
        poses_.assign(poses);
        index_of_body_.assign(by_body.size(), 0);
        std::size_t index = 0;
        for (const auto& [id, entity] : state_.entities.all())
            index_of_body_[entity.body.index] = index++;
        return;
    }
    for (const BodyId id : awake_)
        if (const Result<BodyState> body = world.body(id); body.ok() && !body->awake)
            poses_.set(index_of_body_[id.index], body->pose, false);
    for (const BodyState& body : bodies_)
        poses_.set(index_of_body_[body.id.index], body.pose, body.awake);
}

void HostedWorld::copy_data_into(Frame& frame) {
    frame.players = state_.players.publish(frame.tick);
    frame.attributes = state_.attributes.publish(frame.tick);
    frame.messages = state_.messages.publish(frame.tick);
    frame.has_new_data = frame.players != published_players_ ||
                         frame.attributes != published_attributes_ ||
                         frame.messages != published_messages_;
    published_players_ = frame.players;
    published_attributes_ = frame.attributes;
    published_messages_ = frame.messages;
}

void HostedWorld::copy_into(Frame& frame) {
    const World& world = state_.world;
    const bool list_changed = entity_list_ != state_.entities.list();
    world.copy_awake_bodies(bodies_);
    frame.awake = 0;
    for (const BodyState& body : bodies_)
        frame.awake += body.awake && body.type == BodyType::dynamic ? 1 : 0;
    std::vector<BodyId> awake;
    awake.reserve(bodies_.size());
    for (const BodyState& body : bodies_) awake.push_back(body.id);
    copy_poses(list_changed || static_revision_ != world.static_revision());
    awake_ = std::move(awake);
    static_revision_ = world.static_revision();

    bool moved = false;
    frame.entities = poses_.take(moved);
    frame.entity_list = entity_list_ = state_.entities.list();
    ASSERT(frame.entities.size() == frame.entity_list->size());
    frame.previous_changed_at = changed_at_;
    copy_data_into(frame);
    if (moved || list_changed || published_channels_ != channels_.channels() ||
        published_points_ != channels_.points())
        changed_at_ = frame.tick;
    frame.changed_at = changed_at_;
    ASSERT(frame.previous_changed_at <= frame.changed_at && frame.changed_at <= frame.tick);
    frame.channels = published_channels_ = channels_.channels();
    frame.points = published_points_ = channels_.points();
    if (publishes_controlled_entities_) {
        auto controlled_entities = state_.controllers.controlled_states(
            state_.world, [this](BodyId body) { return state_.entities.find_living(body); });
        if (!controlled_entities.empty())
            frame.controlled_entities = std::make_shared<const std::vector<ControlledEntityState>>(
                std::move(controlled_entities));
    }
    if (publishes_joints_)
        frame.joint_list =
            joints_.list(world, [this](BodyId body) { return state_.entities.find_living(body); });
    if (room_) frame.room = room_->view();
    frame.contacts = world.profile().touching;
    frame.step_ms = world.profile().step_ms;
}

}  // namespace jostle::server
