// SPDX-License-Identifier: MIT
#include "stages/solver/solve_joints.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "constraints/joints/write_joint.h"
#include "constraints/kernels.h"
#include "foundation/prefetch.h"
#include "state/joint_graph.h"

namespace jostle::physics {
namespace {

// With fewer blocks in a run, waking another thread costs more than it does.
constexpr int grain = 8, shared_blocks = 32;

JointEnd end_of(const WorldState& world, std::uint32_t body, const Transform& frame,
                std::int32_t hot) {
    const BodyWarm& warm = hot != 0
                               ? world.bodies.awake[static_cast<std::size_t>(std::abs(hot)) - 1]
                               : warm_of(world, body);
    return {.hot = hot,
            .center = warm.center,
            .arm = warm.axes * (frame.position - world.bodies.cold[body].local_center),
            .rotation = warm.rotation,
            .frame = warm.rotation * frame.rotation};
}

// The joints of the bodies, in order.
void find_joints(const WorldState& world, const JointPart& part) {
    JointScratch& scratch = part.scratch;
    scratch.marks.assign((world.joints.joints.size() + 63) / 64, 0);
    const std::span<const std::uint32_t> bodies = part.bodies;
    const auto cold_of = [&](std::size_t k) -> const BodyCold& {
        return world.bodies.cold[world.bodies.awake[bodies[k] - 1].body];
    };
    for (std::size_t k = 0; k < bodies.size(); k++) {
        if (k + 8 < bodies.size())
            prefetch(world.joints.joints[cold_of(k + 8).first_joint / 2], 0, sizeof(Joint::next));
        for_each_joint(world.joints, cold_of(k), [&](std::uint32_t joint) {
            scratch.marks[joint / 64] |= 1ull << (joint % 64);
        });
    }
    scratch.found.clear();
    for (std::size_t word = 0; word < scratch.marks.size(); word++)
        for (std::uint64_t bits = scratch.marks[word]; bits != 0; bits &= bits - 1)
            scratch.found.push_back({.joint = static_cast<std::uint32_t>(word * 64) +
                                              static_cast<std::uint32_t>(std::countr_zero(bits))});
}

// A joint's level is above that of every joint before it that shares a body that they can push, so
// solving level after level gives each body its joints in their order: a chain hears of its end
// within one pass, as if they were solved one by one.
int assign_levels(const WorldState& world, JointScratch& scratch) {
    scratch.reached.assign(world.scratch.hot.size(), 0);
    std::uint32_t levels = 0;
    const auto hot_of = [&](std::uint32_t body) -> std::int32_t {
        const BodyCold& cold = world.bodies.cold[body];
        if (cold.set != BodySet::awake) return 0;
        const auto hot = static_cast<std::int32_t>(cold.at + 1);
        return cold.inverse_mass != 0 ? hot : -hot;
    };
    const auto reached = [&](std::int32_t hot) -> std::uint32_t& {
        return scratch.reached[static_cast<std::size_t>(std::max(hot, 0))];
    };
    for (FoundJoint& found : scratch.found) {
        const Joint& joint = world.joints.joints[found.joint];
        found.a = hot_of(joint.body_a);
        found.b = hot_of(joint.body_b);
        const std::uint32_t level = std::max(reached(found.a), reached(found.b));
        reached(found.a) = reached(found.b) = level + 1;
        scratch.reached[0] = 0;  // what cannot be pushed makes nobody wait
        levels = std::max(levels, level + 1);
        found.run = level * joint_kinds + static_cast<std::uint32_t>(joint.kind.index());
    }
    return static_cast<int>(levels);
}

bool has_turns(std::uint32_t kind) {
    return kind != JointKind(BallJoint{}).index();
}

// One run for each kind in each level, and a place in a block for each joint.
void lay_out_runs(JointScratch& scratch, int levels) {
    scratch.places.assign(static_cast<std::size_t>(levels) * joint_kinds, 0);
    for (const FoundJoint& found : scratch.found) scratch.places[found.run]++;
    scratch.runs.clear();
    int blocks = 0, turns = 0;
    for (std::uint32_t key = 0; key < scratch.places.size(); key++) {
        const int count = scratch.places[key];
        scratch.places[key] = blocks * 8;  // the next free lane
        if (count == 0) continue;
        const std::uint32_t kind = key % joint_kinds;
        const int size = (count + 7) / 8;
        const int first = has_turns(kind) ? turns : -1;
        scratch.runs.push_back({.kind = static_cast<std::uint8_t>(kind),
                                .begin = blocks,
                                .end = blocks + size,
                                .turns = first});
        blocks += size;
        if (has_turns(kind)) turns += size;
    }
    scratch.sides.assign(static_cast<std::size_t>(blocks), {});
    for (const JointRun& run : scratch.runs)
        for (int k = run.begin; k < run.end; k++)
            scratch.sides[static_cast<std::size_t>(k)].turns =
                run.turns < 0 ? -1 : run.turns + k - run.begin;
    for (const FoundJoint& found : scratch.found) {
        const int lane = scratch.places[found.run]++;
        JointConstraintWideMeta& side = scratch.sides[static_cast<std::size_t>(lane / 8)];
        side.joint[side.count] = found.joint;
        side.a[side.count] = found.a;
        side.b[side.count] = found.b;
        side.count++;
    }
    scratch.blocks.resize(static_cast<std::size_t>(blocks));
    scratch.turns.resize(static_cast<std::size_t>(turns));
}

JointAngularWide* turns_of(JointScratch& scratch, int first) {
    return first < 0 ? nullptr : &scratch.turns[static_cast<std::size_t>(first)];
}

// Joints of a level lie far apart in memory, and so do their bodies.
void prefetch_ahead(const WorldState& world, const JointConstraintWideMeta& side) {
    for (int lane = 0; lane < side.count; lane++) {
        prefetch(world.joints.joints[side.joint[lane]]);
        for (const std::int32_t hot : {side.a[lane], side.b[lane]})
            if (hot > 0) prefetch(world.bodies.awake[static_cast<std::size_t>(hot) - 1]);
    }
}

// Calls visit(block index, side) for every block, on any thread.
template <class Visit>
void each_block(StepContext& step, JointScratch& scratch, Visit&& visit) {
    WorldState& world = step.world;
    std::vector<JointConstraintWideMeta>& sides = scratch.sides;
    const int count = static_cast<int>(sides.size());
    step.team.run(count, 16, [&](int begin, int end) {
        for (int k = begin; k < end; k++) {
            if (k + 2 < count) prefetch_ahead(world, sides[static_cast<std::size_t>(k + 2)]);
            visit(static_cast<std::size_t>(k), sides[static_cast<std::size_t>(k)]);
        }
    });
}

void run_pass(StepContext& step, JointScratch& scratch, JointPass pass, const JointStep& numbers) {
    for (const JointRun& run : scratch.runs) {
        const int count = run.end - run.begin;
        const auto work = [&](int begin, int end) {
            pass({.blocks = scratch.blocks.data(),
                  .turns = turns_of(scratch, run.turns),
                  .sides = scratch.sides.data(),
                  .kind = run.kind,
                  .first = run.begin,
                  .begin = run.begin + begin,
                  .end = run.begin + end},
                 step.world.scratch.hot.data(), numbers);
        };
        if (count < shared_blocks)
            work(0, count);
        else
            step.team.run(count, grain, work);
    }
}

void each_body(StepContext& step, const JointPart& part, void (*pass)(const BodyRange&)) {
    StepScratch& scratch = step.world.scratch;
    step.team.run(static_cast<int>(part.bodies.size()), 256, [&](int begin, int end) {
        pass({scratch.hot.data(), scratch.drive.data(), part.bodies.data(), begin, end});
    });
}

}  // namespace

void prepare_joints(StepContext& step, const JointPart& part, double h) {
    const WorldState& world = step.world;
    JointScratch& scratch = part.scratch;
    scratch.found.clear();
    scratch.runs.clear();
    scratch.sides.clear();
    if (part.bodies.empty()) return;
    find_joints(world, part);
    lay_out_runs(scratch, assign_levels(world, scratch));
    std::fill(scratch.blocks.begin(), scratch.blocks.end(), JointConstraintWide{});
    std::fill(scratch.turns.begin(), scratch.turns.end(), JointAngularWide{});
    each_block(step, scratch, [&](std::size_t block, JointConstraintWideMeta& side) {
        for (int lane = 0; lane < side.count; lane++) {
            const Joint& joint = world.joints.joints[side.joint[lane]];
            write_joint(joint, end_of(world, joint.body_a, joint.frame_a, side.a[lane]),
                        end_of(world, joint.body_b, joint.frame_b, side.b[lane]), h,
                        scratch.blocks[block], turns_of(scratch, side.turns), side, lane);
        }
    });
}

bool shares_levels(const JointPart& part) {
    std::size_t shared = 0;
    for (const JointRun& run : part.scratch.runs)
        if (run.end - run.begin >= shared_blocks)
            shared += static_cast<std::size_t>(run.end - run.begin);
    return 2 * shared > part.scratch.sides.size();
}

void solve_joints(StepContext& step, const JointPart& part, double h) {
    if (part.scratch.runs.empty()) return;
    const JointStep numbers = joint_step(h);
    each_body(step, part, kernels().begin_joints);
    run_pass(step, part.scratch, kernels().warm_start_joints, numbers);
    run_pass(step, part.scratch, kernels().solve_joints, numbers);
    each_body(step, part, kernels().end_joints);
}

void relax_joints(StepContext& step, const JointPart& part, double h) {
    if (part.scratch.runs.empty()) return;
    each_body(step, part, kernels().begin_joints);
    run_pass(step, part.scratch, kernels().relax_joints, joint_step(h));
    each_body(step, part, kernels().end_joints);
}

void finish_joints(StepContext& step, const JointPart& part) {
    WorldState& world = step.world;
    JointScratch& scratch = part.scratch;
    if (scratch.runs.empty()) return;
    each_block(step, scratch, [&](std::size_t block, JointConstraintWideMeta& side) {
        for (int lane = 0; lane < side.count; lane++) {
            const std::int32_t carrier = carrier_of(side.a[lane], side.b[lane]);
            const Quat carried =
                carrier > 0 ? world.bodies.awake[static_cast<std::size_t>(carrier) - 1].rotation
                            : Quat{};
            if (read_joint(world.joints.joints[side.joint[lane]], carried, step.dt,
                           scratch.blocks[block], turns_of(scratch, side.turns), lane))
                side.overloaded |= static_cast<std::uint8_t>(1u << lane);
        }
    });
}

void break_joints(StepContext& step) {
    WorldState& world = step.world;
    std::vector<std::uint32_t> broken;
    for (JointScratch& scratch : world.scratch.joints) {
        world.profile.joints += static_cast<int>(scratch.found.size());
        for (const JointConstraintWideMeta& side : scratch.sides)
            for (unsigned bits = side.overloaded; bits != 0; bits &= bits - 1)
                broken.push_back(side.joint[std::countr_zero(bits)]);
        scratch.found.clear();
        scratch.sides.clear();
    }
    // In their own order, whichever part they were in.
    std::sort(broken.begin(), broken.end());
    for (const std::uint32_t index : broken) {
        const Joint& joint = world.joints.joints[index];
        world.events.joints_broke.push_back({joint_id(world, index), body_id(world, joint.body_a),
                                             body_id(world, joint.body_b), length(joint.force),
                                             length(joint.torque)});
        destroy_joint(world, index);
    }
}

}  // namespace jostle::physics
