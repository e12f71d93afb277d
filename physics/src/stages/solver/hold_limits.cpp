// SPDX-License-Identifier: MIT
#include "physics/src/stages/solver/hold_limits.h"

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "jostle/base/check.h"
#include "physics/src/constraint_graph/joint_memory.h"
#include "physics/src/constraints/direct/joint_net.h"
#include "physics/src/constraints/joints/joint_lane.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/solver/solver_velocities.h"
#include "physics/src/stages/step_scratch.h"

namespace jostle::physics {
namespace {

using Pair = LimitedGroups::Pair;

// A group is solved once more if a sub-step would end with a wider gap or further beyond a limit
// than this.
constexpr double held_gap = 2e-3;     // m
constexpr double held_angle = 0.015;  // rad
constexpr double held_left = 2e-4;    // m: what may remain
// A body that turns by less than this in a sub-step opens no joint by as much.
constexpr double straight_turn = 0.12;  // rad
constexpr int groups_per_share = 4;     // of a thread
// An angle may change faster than two bodies turn against each other.
constexpr double angle_gain = 1.5;

// ---- finding ----

std::int32_t root_of(std::vector<std::int32_t>& parent, std::int32_t hot) {
    while (parent[as_index(hot)] != hot) {
        parent[as_index(hot)] = parent[as_index(parent[as_index(hot)])];
        hot = parent[as_index(hot)];
    }
    return hot;
}

// Joins the bodies of each joint that holds a point, under the lowest hot index.
void join_bodies(const JointStore& joints, const JointTask& task, std::size_t hot_count) {
    std::vector<std::int32_t>& parent = task.limited.parent;
    parent.resize(hot_count);
    for (const std::uint32_t hot : task.bodies) parent[hot] = static_cast<std::int32_t>(hot);
    for (std::size_t k = 0; k < task.levels.joints.size(); k++) {
        const LeveledJoint& joint = task.levels.joints[k];
        if (!holds_point(joints.joints[joint.joint].kind)) continue;
        task.limited.pairs.push_back({joint.a, joint.b, static_cast<std::uint32_t>(k)});
        if (joint.a <= 0 || joint.b <= 0) continue;
        const std::int32_t a = root_of(parent, joint.a), b = root_of(parent, joint.b);
        parent[as_index(std::max(a, b))] = std::min(a, b);
    }
}

// ---- one group ----

DirectEnd held_end(const BodySets& sets, std::uint32_t body, const Transform& frame) {
    const Vec3 center = body == none ? Vec3{} : sets.bodies.cold[body].local_center;
    return {frame.position - center, frame.rotation};
}

int add_held_body(const StepContext& step, LimitedGroup& group, std::uint32_t body,
                  std::int32_t hot) {
    const WorldState& world = step.world;
    if (hot > 0)
        for (std::size_t k = group.bodies.size(); k-- > 0;)
            if (group.bodies[k] == static_cast<std::uint32_t>(hot)) return static_cast<int>(k);
    DirectBody added;
    if (body != none) {
        const BodyCold& cold = world.bodies.cold[body];
        const BodyWarm& warm = warm_of(world, body);
        added.x = warm.center;
        added.q = warm.rotation;
        if (hot > 0) {
            added.pushed = true;
            added.mass = cold.mass;
            added.inverse_mass = cold.inverse_mass;
            added.inverse_masses = free_directions(cold) * cold.inverse_mass;
            added.moments = {cold.inertia.x.x, cold.inertia.y.y, cold.inertia.z.z};
        }
    }
    added.axes = to_matrix(added.q);
    group.bodies.push_back(static_cast<std::uint32_t>(std::abs(hot)));
    group.solver.bodies.push_back(added);
    return static_cast<int>(group.bodies.size()) - 1;
}

// The current state, with the inertia that the solver uses for impulses.
void load_held_body(const StepContext& step, std::uint32_t hot, DirectBody& body) {
    if (hot == 0) return;
    const SolverScratch& scratch = step.scratch.solver;
    const BodyWarm now = motion_now(step.world.bodies, scratch, hot - 1);
    body.x = now.center;
    body.q = now.rotation;
    body.axes = now.axes;
    // SpinAxes::world: the rotation vectors of the sub-steps add up.
    const bool adds_up = scratch.spin_axes[hot] == SpinAxes::world;
    body.turned = adds_up ? to_vec3(scratch.hot[hot].dr) : Vec3{};
    body.turned_from =
        adds_up ? step.world.bodies.awake[hot - 1].rotation : normalized(now.rotation);
    if (!body.pushed) {
        body.v = now.v;
        body.w = now.w;
        return;
    }
    const float* const i = scratch.hot[hot].inertia;
    const Mat3 own{{double{i[0]}, double{i[3]}, double{i[4]}},
                   {double{i[3]}, double{i[1]}, double{i[5]}},
                   {double{i[4]}, double{i[5]}, double{i[2]}}};
    body.inverse_inertia = own;
    if (scratch.spin_axes[hot] == SpinAxes::body) {
        const Mat3 turn = to_matrix(from_rotation_vector(to_vec3(scratch.hot[hot].dr)));
        body.inverse_inertia = turn * own * transpose(turn);
    }
    body.p = now.v * body.mass;
    body.l = inverse(body.inverse_inertia) * now.w;
}

void load_state(const StepContext& step, LimitedGroup& group) {
    for (std::size_t k = 0; k < group.bodies.size(); k++)
        load_held_body(step, group.bodies[k], group.solver.bodies[k]);
}

// Returns false if the group cannot be solved directly.
bool gather_group(StepContext& step, const JointTask& task, std::span<const Pair> pairs,
                  LimitedGroup& group) {
    const WorldState& world = step.world;
    DirectGroup& solver = group.solver;
    group.bodies.clear();
    solver.bodies.clear();
    solver.joints.clear();
    std::int64_t cubes = 0;
    for (const Pair& pair : pairs) {
        const Joint& from = world.joints.joints[task.levels.joints[pair.at].joint];
        DirectJoint& joint = solver.joints.emplace_back();
        joint.a = add_held_body(step, group, from.body_a, pair.a);
        joint.b = add_held_body(step, group, from.body_b, pair.b);
        set_up_rigid(joint, from.kind, held_end(world, from.body_a, from.frame_a),
                     held_end(world, from.body_b, from.frame_b));
        cubes += std::int64_t{joint.rows()} * joint.rows() * joint.rows();
    }
    if (is_net(static_cast<int>(solver.joints.size()), static_cast<int>(solver.bodies.size())))
        return false;
    load_state(step, group);
    // prepare() needs the response of the limits.
    for (DirectJoint& joint : solver.joints) write_vectors(joint, solver.bodies);
    return solver.prepare(tuning::direct_work * cubes);
}

void hold_group(StepContext& step, const JointTask& task, std::span<const Pair> pairs,
                LimitedGroup& group, double h) {
    DirectGroup& solver = group.solver;
    load_state(step, group);
    for (DirectJoint& joint : solver.joints) joint.force_sum = joint.torque_sum = Vec3{};
    std::vector<Vec3> before;
    for (const DirectBody& body : solver.bodies) before.push_back(body.p), before.push_back(body.l);
    if (!solver.hold_joints(h, {held_gap, held_angle, held_left})) return;
    for (std::size_t k = 0; k < solver.bodies.size(); k++) {
        const DirectBody& body = solver.bodies[k];
        if (body.pushed)
            apply_solver_impulse(step.world.bodies, step.scratch.solver, group.bodies[k] - 1,
                                 body.p - before[2 * k], body.l - before[2 * k + 1]);
    }
    for (std::size_t k = 0; k < pairs.size(); k++) {
        const LeveledJoint& at = task.levels.joints[pairs[k].at];
        const Vec3 force = solver.joints[k].force_sum;
        for (int axis = 0; axis < 3; axis++)
            task.levels.blocks[as_index(at.block)].force[axis][at.lane] += as_float(force[axis]);
    }
}

// Most groups are at rest most of the time, and a system takes some 30 KB.
void release_unused(std::unique_ptr<LimitedGroup>& group) {
    if (group == nullptr) return;
    if (group->used)
        group->used = false;
    else
        group = nullptr;
}

// Angle to the nearest limit, rad, as the joint passes found it.
double margin_of(const JointLevels& levels, const Pair& pair) {
    const LeveledJoint& joint = levels.joints[pair.at];
    if (!is_limited_kernel(joint.kind)) return double{never};
    const JointConstraintWideMeta& meta = levels.metas[as_index(joint.block)];
    ASSERT(meta.angular >= 0);
    return double{levels.angular[as_index(meta.angular)].margin[joint.lane]};
}

// Whether the sub-step may open the joint or exceed a limit. Spins of bodies that turn fast are
// stored in other axes, which is good enough.
bool may_fail(const SolverBodies& hot, const JointLevels& levels, const Pair& pair, double h) {
    const float* const a = hot[as_index(std::abs(pair.a))].w;
    const float* const b = hot[as_index(std::abs(pair.b))].w;
    double of_a = 0, of_b = 0, apart = 0;
    for (int k = 0; k < 3; k++) {
        const double x{a[k]}, y{b[k]};
        of_a += x * x;
        of_b += y * y;
        apart += (y - x) * (y - x);
    }
    if (maximum(of_a, of_b) * h * h > straight_turn * straight_turn) return true;
    const double margin = margin_of(levels, pair) + held_angle;
    return margin < 0 || apart * h * h * angle_gain * angle_gain > margin * margin;
}

}  // namespace

void find_limited_groups(StepContext& step, const JointTask& task) {
    LimitedGroups& limited = task.limited;
    limited.pairs.clear();
    limited.groups.clear();
    const std::vector<LeveledJoint>& joints = task.levels.joints;
    if (std::none_of(joints.begin(), joints.end(),
                     [](const LeveledJoint& joint) { return is_limited_kernel(joint.kind); }))
        return;
    join_bodies(step.world.joints, task, step.scratch.solver.hot.size());
    const auto root = [&](const Pair& pair) {
        return root_of(limited.parent, pair.b > 0 ? pair.b : pair.a);
    };
    std::stable_sort(limited.pairs.begin(), limited.pairs.end(),
                     [&](const Pair& x, const Pair& y) { return root(x) < root(y); });
    const auto count = static_cast<std::uint32_t>(limited.pairs.size());
    for (std::uint32_t first = 0, last = 0; first < count; first = last) {
        std::uint32_t key = none;
        bool has_limit = false;
        for (last = first; last < count && root(limited.pairs[last]) == root(limited.pairs[first]);
             last++) {
            const LeveledJoint& joint = joints[limited.pairs[last].at];
            key = std::min(key, joint.joint);
            has_limit |= is_limited_kernel(joint.kind);
        }
        if (!has_limit) continue;
        limited.groups.push_back({first, last, key});
        release_unused(step.scratch.solver.limited_groups[key]);
    }
}

void hold_limited_groups(StepContext& step, const JointTask& task, double h) {
    const auto hold = [&](LimitedGroups::Range& range) {
        const std::span<const Pair> pairs =
            std::span(task.limited.pairs).subspan(range.first, range.last - range.first);
        if (std::none_of(pairs.begin(), pairs.end(), [&](const Pair& pair) {
                return may_fail(step.scratch.solver.hot, task.levels, pair, h);
            }))
            return;
        std::unique_ptr<LimitedGroup>& group = step.scratch.solver.limited_groups[range.key];
        if (group == nullptr) group = std::make_unique<LimitedGroup>();
        group->used = true;
        if (!range.gathered) group->usable = gather_group(step, task, pairs, *group);
        range.gathered = true;
        if (group->usable) hold_group(step, task, pairs, *group, h);
    };
    if (task.limited.groups.empty()) return;
    step.thread_pool.run(static_cast<int>(task.limited.groups.size()), groups_per_share,
                         [&](int begin, int end) {
                             for (int k = begin; k < end; k++)
                                 hold(task.limited.groups[as_index(k)]);
                         });
}

}  // namespace jostle::physics
