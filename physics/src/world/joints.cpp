// SPDX-License-Identifier: MIT
//
// Creation, destruction, reading and control of joints.
#include <algorithm>
#include <array>
#include <string_view>

#include "jostle/base/check.h"
#include "jostle/physics/joint_fields.h"
#include "jostle/physics/world.h"
#include "physics/src/constraint_graph/joint_memory.h"
#include "physics/src/constraints/direct/joint_net.h"
#include "physics/src/constraints/joints/angles.h"
#include "physics/src/constraints/joints/axes_layout.h"
#include "physics/src/foundation/messages.h"
#include "physics/src/state/contact_graph.h"
#include "physics/src/state/joint_graph.h"
#include "physics/src/state/wake.h"
#include "physics/src/world/checks.h"
#include "physics/src/world/joint_checks.h"

namespace jostle::physics {
namespace {

Status check_joint(const BodyStore& bodies, const JointDef& def) {
    const bool to_world = is_null(def.body_a);
    if (!to_world)
        if (Status s = check_id(bodies, def.body_a); !s.ok()) return s;
    if (Status s = check_id(bodies, def.body_b); !s.ok()) return s;
    if (def.body_a == def.body_b)
        return invalid_argument(
            "body_a and body_b are the same body; a joint needs two different bodies");
    if (!is_dynamic(bodies, def.body_a.index) && !is_dynamic(bodies, def.body_b.index))
        return Error{
            ErrorCode::failed_precondition,
            "neither body_a nor body_b is dynamic; a joint needs at least one dynamic body"};
    if (Status s = check_pose("frame_a", def.frame_a); !s.ok()) return s;
    if (Status s = check_pose("frame_b", def.frame_b); !s.ok()) return s;
    if (Status s = check_range("break_force", def.break_force, 0, 1e15); !s.ok()) return s;
    if (Status s = check_range("break_torque", def.break_torque, 0, 1e15); !s.ok()) return s;
    if (def.solver)
        if (Status s = check_joint_solver("solver", *def.solver); !s.ok()) return s;
    return check_kind(def.kind);
}

JointDef def_of(const BodyStore& bodies, const Joint& j) {
    return {.body_a = body_id(bodies, j.body_a),
            .body_b = body_id(bodies, j.body_b),
            .frame_a = j.frame_a,
            .frame_b = j.frame_b,
            .kind = j.kind,
            .collide_connected = j.collide_connected,
            .break_force = j.break_force,
            .break_torque = j.break_torque,
            .user_data = j.user_data,
            .solver = j.solver};
}

// The display name of a kind, such as "cone-twist".
template <class Kind>
constexpr auto display_name = [] {
    constexpr std::string_view name = JointFields<Kind>::name;
    std::array<char, name.size() + 1> text{};
    std::replace_copy(name.begin(), name.end(), text.begin(), '_', '-');
    return text;
}();

Transform frame_in_world(const BodySets& sets, std::uint32_t body, const Transform& frame) {
    if (body == none) return frame;
    return compose(pose_of(warm_of(sets, body), sets.bodies.cold[body]), frame);
}

// An angle as its limits read it; `slot`: index of its impulses in the joint's memory.
double limited_angle(double angle, const JointLimit& limit, const Joint& joint, int slot) {
    const double* const impulses = &joint.memory[as_index(slot) * AxisImpulses::count];
    return nearest_angle(angle, reference_angle(limit, impulses[AxisImpulses::lower],
                                                impulses[AxisImpulses::upper]));
}

}  // namespace

const char* kind_name(const JointKind& kind) {
    return std::visit([]<class Kind>(const Kind&) { return display_name<Kind>.data(); }, kind);
}

Result<JointId> World::create_joint(const JointDef& def) {
    WorldState& world = *state_;
    if (Status s = check_joint(world.bodies, def); !s.ok()) return s.error();
    const std::uint32_t a = def.body_a.index, b = def.body_b.index;
    if (a != none) wake_body(world, a);
    wake_body(world, b);
    if (!def.collide_connected && a != none)
        destroy_contacts_between(world, world.bodies.cold[a].type == BodyType::dynamic ? a : b,
                                 world.bodies.cold[a].type == BodyType::dynamic ? b : a,
                                 world.events.pending.ended);
    const std::uint32_t index = world.joints.ids.take();
    if (index == world.joints.joints.size()) world.joints.joints.emplace_back();
    Joint& j = world.joints.joints[index];
    j = Joint{};
    j.body_a = a;
    j.body_b = b;
    j.frame_a = {def.frame_a.position, unit(def.frame_a.rotation)};
    j.frame_b = {def.frame_b.position, unit(def.frame_b.rotation)};
    j.kind = def.kind;
    j.memory.assign(memory_of(def.kind), 0);
    j.collide_connected = def.collide_connected;
    j.break_force = def.break_force;
    j.break_torque = def.break_torque;
    j.user_data = def.user_data;
    j.solver = def.solver;
    attach_joint(world, world.joints, index);
    ASSERT(world.bodies.cold[b].first_joint / 2 == index);
    return joint_id(world.joints, index);
}

Status World::destroy_joint(JointId id) {
    WorldState& world = *state_;
    if (Status s = check_id(world.joints, id); !s.ok()) return s;
    const Joint& j = world.joints.joints[id.index];
    if (j.body_a != none) wake_body(world, j.body_a);
    wake_body(world, j.body_b);
    physics::destroy_joint(world, world.joints, id.index);
    return {};
}

Status World::set_joint(JointId id, const JointKind& kind) {
    WorldState& world = *state_;
    if (Status s = check_id(world.joints, id); !s.ok()) return s;
    Joint& j = world.joints.joints[id.index];
    if (kind.index() != j.kind.index())
        return Error{ErrorCode::failed_precondition,
                     std::string("the joint is a ") + kind_name(j.kind) + "; it cannot become a " +
                         kind_name(kind) + ": destroy it and create another"};
    if (j.kind == kind) return {};
    if (Status s = check_kind(kind); !s.ok()) return s;
    j.kind = kind;
    reset_density(world, world.joints, id.index);
    if (j.body_a != none) wake_body(world, j.body_a);
    wake_body(world, j.body_b);
    return {};
}

Status World::set_joint_solver(JointId id, std::optional<JointSolver> solver) {
    WorldState& world = *state_;
    if (Status s = check_id(world.joints, id); !s.ok()) return s;
    if (solver)
        if (Status s = check_joint_solver("solver", *solver); !s.ok()) return s;
    world.joints.joints[id.index].solver = solver;
    reset_density(world, world.joints, id.index);
    return {};
}

std::uint64_t World::joint_revision() const {
    return state_->joints.revision;
}

bool World::contains(JointId joint) const {
    return check_id(state_->joints, joint).ok();
}

Result<JointState> World::joint(JointId id) const {
    const WorldState& world = *state_;
    if (Status s = check_id(world.joints, id); !s.ok()) return s.error();
    const Joint& j = world.joints.joints[id.index];
    const Transform a = frame_in_world(world, j.body_a, j.frame_a),
                    b = frame_in_world(world, j.body_b, j.frame_b);
    JointState state{.id = id,
                     .def = def_of(world.bodies, j),
                     .force = j.force,
                     .torque = j.torque,
                     .separation = length(b.position - a.position)};
    if (const auto* hinge = std::get_if<HingeJoint>(&j.kind))
        state.angle = nearest_angle(hinge_angle(a.rotation, b.rotation),
                                    reference_angle(hinge->limit, j.lower, j.upper));
    if (const auto* cone = std::get_if<ConeTwistJoint>(&j.kind)) {
        state.angle = nearest_angle(twist_angle(a.rotation, b.rotation),
                                    reference_angle(cone->twist, j.lower, j.upper));
        state.swing = swing_angle(a.rotation, b.rotation);
    }
    state.offset = inverse_rotate(a.rotation, b.position - a.position);
    if (const auto* pulley = std::get_if<PulleyJoint>(&j.kind))
        state.travel = length(a.position - pulley->point_a) +
                       pulley->ratio * length(b.position - pulley->point_b);
    if (const auto* path = std::get_if<PathJoint>(&j.kind)) {
        ASSERT(j.memory.size() == memory_of(j.kind));
        const PathPoint path_point =
            j.memory[PathMemory::found] == 0
                ? nearest_path_point(*path, state.offset)
                : nearest_path_point(*path, state.offset, j.memory[PathMemory::at]);
        state.travel = path_point.travel;
        state.separation = length(state.offset - path_point.position);
    }
    if (std::holds_alternative<SliderJoint>(j.kind)) state.travel = state.offset.z;
    if (const auto* six = std::get_if<SixDofJoint>(&j.kind)) {
        const GimbalAngles turns = pose_of(layout_of(*six), a, b).turns;
        const double angles[] = {turns.first, turns.middle, turns.last};
        const int first = middle_turn(*six->axes) + 2;
        const JointAxis* const axes[] = {&six->axes->rotation_x, &six->axes->rotation_y,
                                         &six->axes->rotation_z};
        const auto angle_about = [&](int own) {
            return limited_angle(angles[(3 + own - first % 3) % 3], axes[own]->limit, j, 3 + own);
        };
        state.angles = {angle_about(0), angle_about(1), angle_about(2)};
    }
    if (const auto* wheel = std::get_if<WheelJoint>(&j.kind)) {
        WheelJoint straight = *wheel;
        straight.steering = 0;
        const GimbalAngles turns = pose_of(layout_of(straight), a, b).turns;
        state.travel = state.offset.y;
        state.angle = turns.last;
        const JointLimit steering = wheel->free_steering ? wheel->steering_limit : JointLimit{};
        state.angles = {0, limited_angle(turns.first, steering, j, 1), turns.last};
    }
    return state;
}

std::vector<JointId> World::joints() const {
    std::vector<JointId> ids;
    for (std::uint32_t i = 0; i < state_->joints.ids.size(); i++)
        if (state_->joints.ids.alive(i)) ids.push_back(joint_id(state_->joints, i));
    return ids;
}

std::vector<JointId> World::joints_of(BodyId body) const {
    std::vector<JointId> ids;
    if (!contains(body)) return ids;
    for_each_joint(state_->joints, state_->bodies.cold[body.index],
                   [&](std::uint32_t joint) { ids.push_back(joint_id(state_->joints, joint)); });
    std::sort(ids.begin(), ids.end());
    return ids;
}

Status World::set_user_data(JointId joint, std::uint64_t data) {
    if (Status s = check_id(state_->joints, joint); !s.ok()) return s;
    state_->joints.joints[joint.index].user_data = data;
    return {};
}

}  // namespace jostle::physics
