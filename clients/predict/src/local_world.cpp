// SPDX-License-Identifier: MIT
#include "local_world.h"

#include <utility>
#include <vector>

#include "jostle/modules/hand.h"
#include "jostle/scenes/shape_message.h"

namespace jostle::client {

using namespace physics;

namespace {

Vec3 to_vector(const v1::Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

BodyType to_type(v1::BodyType type) {
    if (type == v1::BODY_TYPE_DYNAMIC) return BodyType::dynamic;
    return type == v1::BODY_TYPE_KINEMATIC ? BodyType::kinematic : BodyType::static_body;
}

std::optional<std::vector<ShapeDef>> shapes_of(const WorldView& view, const v1::Entity& entity) {
    std::vector<ShapeDef> shapes;
    for (const v1::Shape& told : entity.shapes()) {
        const v1::Shape* outline = view.outline_of(told);
        if (!outline) return std::nullopt;
        v1::Shape whole = *outline;
        if (outline != &told) {
            whole = told;
            whole.clear_kind();
            whole.MergeFrom(*outline);
        }
        const auto shape = scenes::shape_from_message(whole, "shape");
        if (!shape.ok()) return std::nullopt;
        shapes.push_back(*shape);
    }
    return shapes;
}

}  // namespace

Transform to_transform(const wire::Pose& pose) {
    const auto& p = pose.position;
    const auto& q = pose.rotation;
    return {.position = {p[0], p[1], p[2]}, .rotation = {q[0], q[1], q[2], q[3]}};
}

wire::Pose to_pose(const Transform& pose) {
    const Vec3& p = pose.position;
    const Quat& q = pose.rotation;
    return {{p.x, p.y, p.z}, {q.x, q.y, q.z, q.w}};
}

LocalWorld::LocalWorld(Vec3 gravity, int substeps)
    : world_(WorldDef{.gravity = gravity, .substeps = substeps}) {}

LocalWorld::Members& LocalWorld::change() {
    auto changed = std::make_shared<Members>(*members_);
    Members& members = *changed;
    members_ = std::move(changed);
    return members;
}

bool LocalWorld::add(const WorldView& view, const v1::Entity& entity, const Motion& motion,
                     bool at_rest) {
    const auto shapes = shapes_of(view, entity);
    if (!shapes) return false;
    const BodyType type = to_type(entity.type());
    BodyDef def{.type = type, .pose = motion.pose};
    if (type != BodyType::static_body) {
        def.linear_velocity = motion.linear;
        def.angular_velocity = motion.angular;
    }
    if (type == BodyType::dynamic) def.mass = entity.mass();
    const Result<BodyId> body = world_.create_body(def, *shapes);
    if (!body.ok()) return false;
    Members& members = change();
    (type == BodyType::dynamic ? members.moving : members.fixed)[entity.id()] = *body;
    if (type == BodyType::dynamic) set_motion(entity.id(), motion, at_rest);
    return true;
}

void LocalWorld::remove(std::uint32_t entity) {
    Members& members = change();
    for (auto* list : {&members.moving, &members.fixed}) {
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

void LocalWorld::apply(const v1::Input& input) {
    switch (input.kind_case()) {
        case v1::Input::kImpulse: {
            const v1::ImpulseInput& push = input.impulse();
            const auto at = members_->moving.find(push.entity());
            if (at == members_->moving.end()) return;
            const auto point =
                push.has_point() ? std::optional(to_vector(push.point())) : std::optional<Vec3>();
            static_cast<void>(modules::push_by_hand(world_, *world_.body(at->second),
                                                    to_vector(push.impulse()), point)
                                  .ok());
            return;
        }
        case v1::Input::kGrab:
            return hold(input.grab());
        case v1::Input::kDrag:
            return drag(input.drag());
        case v1::Input::kRelease:
            return release();
        default:
            return;  // what it does is not foreseen
    }
}

void LocalWorld::hold(const v1::GrabInput& input) {
    release();
    const auto at = members_->moving.find(input.entity());
    if (at == members_->moving.end()) return;
    const Result<JointId> joint =
        world_.create_joint(modules::held_at(*world_.body(at->second), to_vector(input.point())));
    if (joint.ok()) change().held = *joint;
}

void LocalWorld::drag(const v1::DragInput& input) {
    if (!members_->held) return;
    const Result<JointState> joint = world_.joint(*members_->held);
    if (!joint.ok()) return;
    GrabJoint kind = std::get<GrabJoint>(joint->def.kind);
    kind.target = to_vector(input.target());
    static_cast<void>(world_.set_joint(*members_->held, kind).ok());
}

void LocalWorld::release() {
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
