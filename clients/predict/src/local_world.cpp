// SPDX-License-Identifier: MIT
#include "local_world.h"

#include <utility>

#include "jostle/modules/hand.h"

namespace jostle::client {

using namespace physics;

LocalWorld::LocalWorld(Vec3 gravity, int substeps)
    : world_(WorldDef{.gravity = gravity, .substeps = substeps}) {}

LocalWorld::Members& LocalWorld::change() {
    auto changed = std::make_shared<Members>(*members_);
    Members& members = *changed;
    members_ = std::move(changed);
    return members;
}

bool LocalWorld::add(std::uint32_t entity, BodyType type, double mass,
                     std::span<const ShapeDef> shapes, const Motion& motion, bool at_rest) {
    BodyDef def{.type = type, .pose = motion.pose};
    if (type != BodyType::static_body) {
        def.linear_velocity = motion.linear;
        def.angular_velocity = motion.angular;
    }
    if (type == BodyType::dynamic) def.mass = mass;
    const Result<BodyId> body = world_.create_body(def, shapes);
    if (!body.ok()) return false;
    Members& members = change();
    (type == BodyType::dynamic ? members.moving : members.fixed)[entity] = *body;
    if (type == BodyType::dynamic) set_motion(entity, motion, at_rest);
    return true;
}

bool LocalWorld::add_to_rim(std::uint32_t entity, std::span<const ShapeDef> shapes,
                            const Transform& pose) {
    const Result<BodyId> body =
        world_.create_body({.type = BodyType::static_body, .pose = pose}, shapes);
    if (body.ok()) change().rim[entity] = *body;
    return body.ok();
}

void LocalWorld::move_rim(std::uint32_t entity, const Transform& pose) {
    const auto at = members_->rim.find(entity);
    if (at != members_->rim.end()) static_cast<void>(world_.set_pose(at->second, pose).ok());
}

void LocalWorld::remove(std::uint32_t entity) {
    Members& members = change();
    for (auto* list : {&members.moving, &members.fixed, &members.rim}) {
        const auto at = list->find(entity);
        if (at == list->end()) continue;
        static_cast<void>(world_.destroy_body(at->second).ok());
        list->erase(at);
    }
    if (members.held && !world_.contains(*members.held)) members.held.reset();
}

Motion LocalWorld::motion(std::uint32_t entity) const {
    const BodyState body = *world_.body(members_->moving.at(entity));
    return {body.pose, body.linear_velocity, body.angular_velocity};
}

// What is foreign and cannot be so leaves the body as it was.
void LocalWorld::set_motion(std::uint32_t entity, const Motion& motion, bool at_rest) {
    const BodyId body = members_->moving.at(entity);
    if (!world_.set_pose(body, motion.pose).ok()) return;
    if (!world_.set_velocity(body, motion.linear, motion.angular).ok()) return;
    if (at_rest) static_cast<void>(world_.set_awake(body, false).ok());
}

void LocalWorld::apply(const Act& act) {
    std::visit([this](const auto& one) { perform(one); }, act);
}

void LocalWorld::perform(const Push& push) {
    const auto at = members_->moving.find(push.entity);
    if (at == members_->moving.end()) return;
    static_cast<void>(
        modules::push_by_hand(world_, *world_.body(at->second), push.impulse, push.point).ok());
}

void LocalWorld::perform(const Grab& grab) {
    perform(Release{});
    const auto at = members_->moving.find(grab.entity);
    if (at == members_->moving.end()) return;
    const Result<JointId> joint =
        world_.create_joint(modules::held_at(*world_.body(at->second), grab.point));
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

void LocalWorld::step(double seconds) {
    static_cast<void>(world_.step(seconds).ok());
}

void LocalWorld::keep(Moment& moment, std::uint32_t tick) const {
    moment.tick = tick;
    moment.point.keep(world_);
    moment.members = members_;
    moment.motions.clear();
    for (const auto& [entity, body] : members_->moving) moment.motions[entity] = motion(entity);
}

void LocalWorld::go_back(const Moment& moment) {
    static_cast<void>(moment.point.restore(world_).ok());
    members_ = moment.members;
}

}  // namespace jostle::client
