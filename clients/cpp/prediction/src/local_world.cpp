// SPDX-License-Identifier: MIT
#include "clients/cpp/prediction/src/local_world.h"

#include <utility>

#include "jostle/modules/character.h"
#include "jostle/modules/controlled_entity_state.h"
#include "jostle/modules/player_interaction.h"
#include "jostle/modules/vehicle.h"

namespace jostle::client {

using namespace physics;

namespace {

// Registers the modules that control entities and publish their state. Idempotent.
void know_modules() {
    static const bool known = [] {
        static_cast<void>(register_module("character", [] {
                              return std::make_unique<modules::Characters>();
                          }).ok());
        static_cast<void>(
            register_module("vehicle", [] { return std::make_unique<modules::Vehicles>(); }).ok());
        return true;
    }();
    static_cast<void>(known);
}

}  // namespace

LocalWorld::LocalWorld(Vec3 gravity, int substeps)
    : world_(WorldDef{.gravity = gravity, .substeps = substeps}) {}

LocalWorld::Members& LocalWorld::change() {
    auto changed = std::make_shared<Members>(*members_);
    Members& members = *changed;
    members_ = std::move(changed);
    return members;
}

bool LocalWorld::add(std::uint32_t entity, const LocalBody& of, std::span<const ShapeDef> shapes,
                     const MotionState& motion, bool at_rest) {
    BodyDef def{.type = of.type, .pose = motion.pose};
    if (of.simulated) {
        def.linear_velocity = motion.linear;
        def.angular_velocity = motion.angular;
    }
    if (of.type == BodyType::dynamic) {
        def.mass = of.mass;
        def.linear_damping = of.linear_damping;
        def.angular_damping = of.angular_damping;
        def.gravity_scale = of.gravity_scale;
        def.locks = of.locks;
    }
    const Result<BodyId> body = world_.create_body(def, shapes);
    if (!body.ok()) return false;
    Members& members = change();
    (of.simulated ? members.moving : members.fixed)[entity] = *body;
    if (of.simulated) set_motion(entity, motion, at_rest);
    return true;
}

bool LocalWorld::add_boundary_body(std::uint32_t entity, std::span<const ShapeDef> shapes,
                                   const Transform& pose) {
    const Result<BodyId> body =
        world_.create_body({.type = BodyType::static_body, .pose = pose}, shapes);
    if (body.ok()) change().boundary[entity] = *body;
    return body.ok();
}

void LocalWorld::put(std::uint32_t entity, const Transform& pose) {
    const BodyId body = body_of(entity);
    const Result<BodyState> now = world_.body(body);
    if (now.ok() && !(now->pose == pose)) static_cast<void>(world_.set_pose(body, pose).ok());
}

BodyId LocalWorld::body_of(std::uint32_t entity) const {
    for (const auto* list : {&members_->moving, &members_->fixed, &members_->boundary})
        if (const auto at = list->find(entity); at != list->end()) return at->second;
    return {};
}

bool LocalWorld::set_controlled(std::uint32_t entity, const std::string& tag,
                                std::span<const std::uint32_t> words) {
    const auto at = members_->moving.find(entity);
    if (at == members_->moving.end()) return false;
    know_modules();
    if (world_.module(tag) == nullptr) {
        Result<std::unique_ptr<Module>> made = make_module(tag);
        if (!made.ok() || !world_.add_module(std::move(made).value()).ok()) return false;
    }
    if (!modules::apply_controlled_entity(world_, *world_.module(tag), at->second, words,
                                          [this](std::uint32_t name) { return body_of(name); }))
        return false;
    if (members_->controlled != entity || members_->controller_module != tag) {
        Members& members = change();
        members.controlled = entity;
        members.controller_module = tag;
    }
    return true;
}

void LocalWorld::remove(std::uint32_t entity) {
    Members& members = change();
    for (auto* list : {&members.moving, &members.fixed, &members.boundary}) {
        const auto at = list->find(entity);
        if (at == list->end()) continue;
        static_cast<void>(world_.destroy_body(at->second).ok());
        list->erase(at);
    }
    if (members.held && !world_.contains(*members.held)) members.held.reset();
    if (members.controlled == entity) members.controlled = 0;
}

MotionState LocalWorld::motion(std::uint32_t entity) const {
    const BodyState body = *world_.body(members_->moving.at(entity));
    return {body.pose, body.linear_velocity, body.angular_velocity};
}

double LocalWorld::bounding_radius(std::uint32_t entity) const {
    const BodyId body = body_of(entity);
    const Vec3 origin = world_.body(body)->pose.position;
    double bounding_radius = 0;
    for (const ShapeId shape : world_.shapes_of(body)) {
        const Result<Aabb> bounds = world_.bounds(shape);
        if (!bounds.ok()) continue;
        const Vec3 far = max(abs(bounds->low - origin), abs(bounds->high - origin));
        bounding_radius = maximum(bounding_radius, length(far));
    }
    return bounding_radius;
}

// An invalid motion leaves the body unchanged, because it is untrusted.
void LocalWorld::set_motion(std::uint32_t entity, const MotionState& motion, bool at_rest) {
    const BodyId body = members_->moving.at(entity);
    if (!world_.set_pose(body, motion.pose).ok()) return;
    if (!world_.set_velocity(body, motion.linear, motion.angular).ok()) return;
    if (at_rest) static_cast<void>(world_.set_awake(body, false).ok());
}

void LocalWorld::apply(const InputAction& action) {
    std::visit([this](const auto& one) { perform(one); }, action);
}

void LocalWorld::perform(const Push& push) {
    const auto at = members_->moving.find(push.entity);
    if (at == members_->moving.end()) return;
    static_cast<void>(
        modules::apply_player_impulse(world_, *world_.body(at->second), push.impulse, push.point)
            .ok());
}

void LocalWorld::perform(const Grab& grab) {
    perform(Release{});
    const auto at = members_->moving.find(grab.entity);
    if (at == members_->moving.end()) return;
    const Result<JointId> joint =
        world_.create_joint(modules::make_grab_joint(*world_.body(at->second), grab.point));
    if (joint.ok()) change().held = *joint;
}

void LocalWorld::perform(const Drag& drag) {
    if (!members_->held) return;
    const Result<JointState> joint = world_.joint(*members_->held);
    if (!joint.ok()) return;
    GrabJoint kind = std::get<GrabJoint>(joint->def.kind);
    kind.target = drag.target;
    static_cast<void>(world_.set_joint(*members_->held, kind).ok());
}

void LocalWorld::perform(const Release&) {
    if (!members_->held) return;
    static_cast<void>(world_.destroy_joint(*members_->held).ok());
    change().held.reset();
}

void LocalWorld::perform(const Steer& steer) {
    Module* const module =
        members_->controlled == 0 ? nullptr : world_.module(members_->controller_module);
    if (module != nullptr) module->control(world_, body_of(members_->controlled), steer.controls);
}

void LocalWorld::step(double seconds) {
    static_cast<void>(world_.step(seconds).ok());
}

void LocalWorld::save(TickState& tick_state, std::uint32_t tick) const {
    tick_state.tick = tick;
    tick_state.point.capture(world_);
    tick_state.members = members_;
    tick_state.motions.clear();
    for (const auto& [entity, body] : members_->moving) tick_state.motions[entity] = motion(entity);
}

void LocalWorld::roll_back(const TickState& tick_state) {
    static_cast<void>(tick_state.point.restore(world_).ok());
    members_ = tick_state.members;
}

}  // namespace jostle::client
