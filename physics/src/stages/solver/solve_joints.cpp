// SPDX-License-Identifier: MIT
#include "physics/src/stages/solver/solve_joints.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <utility>

#include "jostle/base/check.h"
#include "physics/src/constraints/joints/gear_ends.h"
#include "physics/src/constraints/joints/write_joint.h"
#include "physics/src/constraints/kernels.h"
#include "physics/src/foundation/prefetch.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/joint_graph.h"

namespace jostle::physics {
namespace {

JointEnd end_of(const BodySets& sets, std::uint32_t body, const Transform& frame,
                std::int32_t hot) {
    if (body == none)  // the world
        return {.center = {}, .arm = frame.position, .rotation = {}, .frame = frame.rotation};
    const BodyWarm& warm = hot != 0 ? sets.bodies.awake[static_cast<std::size_t>(std::abs(hot)) - 1]
                                    : warm_of(sets, body);
    ASSERT(warm.body == body);
    return {.hot = hot,
            .center = warm.center,
            .arm = warm.axes * (frame.position - sets.bodies.cold[body].local_center),
            .rotation = warm.rotation,
            .frame = warm.rotation * frame.rotation};
}

// The joints of the bodies, in ascending order.
void find_joints(const JointStore& store, const BodyStore& all, const JointTask& task) {
    JointLevels& levels = task.levels;
    levels.marks.assign((store.joints.size() + 63) / 64, 0);
    const std::span<const std::uint32_t> bodies = task.bodies;
    const auto cold_of = [&](std::size_t k) -> const BodyCold& {
        return all.cold[all.awake[bodies[k] - 1].body];
    };
    for (std::size_t k = 0; k < bodies.size(); k++) {
        ASSERT(cold_of(k).first_joint != none && !cold_of(k).asleep_in_place);
        if (k + 8 < bodies.size())
            prefetch(store.joints[cold_of(k + 8).first_joint / 2], 0, sizeof(Joint::next));
        for_each_joint(store, cold_of(k), [&](std::uint32_t joint) {
            levels.marks[joint / 64] |= 1ull << (joint % 64);
        });
    }
    levels.joints.clear();
    for (std::size_t word = 0; word < levels.marks.size(); word++)
        for (std::uint64_t bits = levels.marks[word]; bits != 0; bits &= bits - 1)
            levels.joints.push_back({.joint = static_cast<std::uint32_t>(word * 64) +
                                              static_cast<std::uint32_t>(std::countr_zero(bits))});
}

// Their bodies by hot index: negative for bodies that move but cannot be pushed, 0 for immovable
// ones.
std::int32_t hot_of(const BodyStore& bodies, std::uint32_t body) {
    if (body == none) return 0;
    const BodyCold& cold = bodies.cold[body];
    if (cold.set != BodySet::awake) return 0;
    const auto hot = static_cast<std::int32_t>(cold.at + 1);
    return cold.inverse_mass != 0 && !cold.asleep_in_place ? hot : -hot;
}

Carrier carrier_at(const BodySets& sets, std::uint32_t body) {
    if (body == none) return {};
    const BodyWarm& warm = warm_of(sets, body);
    return {.body = body,
            .hot = hot_of(sets.bodies, body),
            .center = warm.center,
            .origin = pose_of(warm, sets.bodies.cold[body]).position,
            .rotation = warm.rotation};
}

void find_bodies(const BodyStore& bodies, const JointStore& joints, JointLevels& levels) {
    const JointStore& store = joints;
    for (LeveledJoint& found : levels.joints) {
        ASSERT(store.ids.alive(found.joint));
        const Joint& joint = store.joints[found.joint];
        found.kind = kernel_of(joint.kind);
        found.a = hot_of(bodies, joint.body_a);
        found.b = hot_of(bodies, joint.body_b);
        if (!joint_is_geared(joint.kind)) continue;
        found.carrier_a = hot_of(bodies, find_carrier(bodies, joints, joint, 0));
        found.carrier_b = hot_of(bodies, find_carrier(bodies, joints, joint, 1));
    }
}

// Joints of a level are scattered in memory, and so are their bodies.
void prefetch_ahead(const JointStore& store, const BodyStore& bodies,
                    const JointConstraintWideMeta& meta) {
    for (int lane = 0; lane < meta.count; lane++) {
        prefetch(store.joints[meta.joint[lane]]);
        for (const std::int32_t hot : {meta.a[lane], meta.b[lane]})
            if (hot > 0) prefetch(bodies.awake[static_cast<std::size_t>(hot) - 1]);
    }
}

// Calls visit(block index, block meta) for every block, on any thread.
template <class Visit>
void each_block(StepContext& step, JointLevels& levels, Visit&& visit) {
    const WorldState& world = step.world;
    std::vector<JointConstraintWideMeta>& metas = levels.metas;
    const int count = static_cast<int>(metas.size());
    step.thread_pool.run(count, tuning::joint_grain * 2, [&](int begin, int end) {
        for (int k = begin; k < end; k++) {
            if (k + 2 < count)
                prefetch_ahead(world.joints, world.bodies, metas[static_cast<std::size_t>(k + 2)]);
            visit(static_cast<std::size_t>(k), metas[static_cast<std::size_t>(k)]);
        }
    });
}

void run_pass(StepContext& step, JointLevels& levels, JointPass pass, const JointStep& numbers) {
    for (const JointRun& run : levels.runs) {
        const int count = run.end - run.begin;
        ASSERT(count > 0 && run.end <= static_cast<int>(levels.blocks.size()));
        const auto work = [&](int begin, int end) {
            pass({.blocks = levels.blocks.data(),
                  .angular = angular_of(levels, run.angular),
                  .rows = row_of(levels, run.row),
                  .axes = axes_of(levels, run.axes),
                  .gears = gear_of(levels, run.gear),
                  .metas = levels.metas.data(),
                  .kind = run.kind,
                  .first = run.begin,
                  .begin = run.begin + begin,
                  .end = run.begin + end},
                 step.scratch.solver.hot.data(), numbers);
        };
        if (count < tuning::shared_joint_blocks)
            work(0, count);
        else
            step.thread_pool.run(count, tuning::joint_grain, work);
    }
}

void each_body(StepContext& step, const JointTask& task, void (*pass)(const BodyRange&)) {
    SolverScratch& scratch = step.scratch.solver;
    step.thread_pool.run(
        static_cast<int>(task.bodies.size()), tuning::body_grain, [&](int begin, int end) {
            pass({scratch.hot.data(), scratch.external.data(), task.bodies.data(), begin, end});
        });
}

}  // namespace

void prepare_joints(StepContext& step, const JointTask& task, double h) {
    const WorldState& world = step.world;
    JointLevels& levels = task.levels;
    levels.joints.clear();
    levels.runs.clear();
    levels.metas.clear();
    task.batches.used = 0;
    if (task.bodies.empty()) return;
    find_joints(world.joints, world.bodies, task);
    find_bodies(world.bodies, world.joints, levels);
    assign_levels(levels, step.scratch.solver.hot.size());
    find_joint_batches(step, task);
    each_block(step, levels, [&](std::size_t block, JointConstraintWideMeta& meta) {
        for (int lane = 0; lane < meta.count; lane++) {
            const Joint& joint = world.joints.joints[meta.joint[lane]];
            write_joint(
                joint, end_of(world, joint.body_a, joint.frame_a, meta.a[lane]),
                end_of(world, joint.body_b, joint.frame_b, meta.b[lane]), h,
                {levels.blocks[block], angular_of(levels, meta.angular), row_of(levels, meta.row),
                 axes_of(levels, meta.axes), gear_of(levels, meta.gear), meta},
                lane);
            if (meta.gear >= 0) {
                const std::uint32_t bodies[] = {find_carrier(world.bodies, world.joints, joint, 0),
                                                find_carrier(world.bodies, world.joints, joint, 1)};
                const Carrier carriers[] = {carrier_at(world, bodies[0]),
                                            carrier_at(world, bodies[1])};
                write_gear(joint, end_of(world, joint.body_a, joint.frame_a, meta.a[lane]),
                           end_of(world, joint.body_b, joint.frame_b, meta.b[lane]), carriers,
                           *gear_of(levels, meta.gear), JointLane{lane});
            }
        }
    });
    load_joint_batches(step, task, h);
}

bool shares_levels(const JointTask& task) {
    std::size_t shared = 0;
    for (const JointRun& run : task.levels.runs)
        if (run.end - run.begin >= tuning::shared_joint_blocks)
            shared += static_cast<std::size_t>(run.end - run.begin);
    return 2 * shared > task.levels.metas.size();
}

void solve_joints(StepContext& step, const JointTask& task, double h) {
    if (task.levels.runs.empty()) return;
    const JointStep numbers = joint_step(h);
    each_body(step, task, kernels().begin_joints);
    run_pass(step, task.levels, kernels().warm_start_joints, numbers);
    run_pass(step, task.levels, kernels().solve_joints, numbers);
    each_body(step, task, kernels().end_joints);
}

void relax_joints(StepContext& step, const JointTask& task, double h) {
    if (task.levels.runs.empty()) return;
    each_body(step, task, kernels().begin_joints);
    run_pass(step, task.levels, kernels().relax_joints, joint_step(h));
    each_body(step, task, kernels().end_joints);
}

void finish_joints(StepContext& step, const JointTask& task) {
    WorldState& world = step.world;
    JointLevels& levels = task.levels;
    if (levels.runs.empty()) return;
    each_block(step, levels, [&](std::size_t block, JointConstraintWideMeta& meta) {
        for (int lane = 0; lane < meta.count; lane++) {
            const std::int32_t carrier =
                carrier_of(world.joints.joints[meta.joint[lane]].kind, meta.a[lane], meta.b[lane]);
            const Quat carried =
                carrier > 0 ? world.bodies.awake[static_cast<std::size_t>(carrier) - 1].rotation
                            : Quat{};
            if (read_joint(world.joints.joints[meta.joint[lane]], carried, step.dt,
                           {levels.blocks[block], angular_of(levels, meta.angular),
                            row_of(levels, meta.row), axes_of(levels, meta.axes),
                            gear_of(levels, meta.gear), meta},
                           lane))
                meta.broken_lanes |= static_cast<std::uint8_t>(1u << lane);
        }
    });
}

void break_joints(StepContext& step) {
    WorldState& world = step.world;
    std::vector<std::uint32_t> broken;
    for (std::size_t set = 0; set < step.scratch.solver.joints.size(); set++) {
        JointLevels& levels = step.scratch.solver.joints[set];
        const auto joints = static_cast<std::int64_t>(levels.joints.size());
        world.profile.joints += static_cast<int>(joints);
        if (joints > 0) world.profile.joint_substeps += joints * step.contacts[set].substeps;
        for (const JointConstraintWideMeta& meta : levels.metas) {
            world.profile.joints_batched += meta.in_batch;
            for (unsigned bits = meta.broken_lanes; bits != 0; bits &= bits - 1)
                broken.push_back(meta.joint[std::countr_zero(bits)]);
        }
        levels.joints.clear();
        levels.metas.clear();
    }
    for (JointBatches& batches : step.scratch.solver.joint_batches)
        world.profile.joints_direct_fallback += std::exchange(batches.refused, 0);
    JointGroupScratch& groups = step.scratch.solver.groups;
    for (const std::uint32_t island : groups.active) {
        const JointGroup& group = *groups.of_island[island];
        world.profile.joints += static_cast<int>(group.joints.size());
        world.profile.joints_direct += static_cast<int>(group.joints.size());
        const DirectGroup::Count& count = group.solver.count();
        world.profile.joint_energy_steps += count.energy_steps;
        world.profile.joint_halvings += count.halvings;
        world.profile.joint_last_resorts += count.last_resorts;
        world.profile.joint_substeps +=
            static_cast<std::int64_t>(group.joints.size()) * group.substeps;
        for (const std::uint32_t index : group.joints)
            if (exceeds_break_limit(world.joints.joints[index])) broken.push_back(index);
    }
    ASSERT(world.profile.joints <= static_cast<int>(world.joints.ids.alive_count()));
    // In order of index, independent of the task that they belonged to.
    std::sort(broken.begin(), broken.end());
    for (const std::uint32_t index : broken) {
        const Joint& joint = world.joints.joints[index];
        world.events.joints_broke.push_back(
            {joint_id(world.joints, index), body_id(world.bodies, joint.body_a),
             body_id(world.bodies, joint.body_b), length(joint.force), length(joint.torque)});
        destroy_joint(world, world.joints, index);
    }
}

}  // namespace jostle::physics
