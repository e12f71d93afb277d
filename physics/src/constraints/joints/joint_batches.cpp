// SPDX-License-Identifier: MIT
#include "physics/src/constraints/joints/joint_batches.h"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <variant>

#include "jostle/base/check.h"
#include "physics/src/foundation/tuning.h"

namespace jostle::physics {
namespace {

constexpr std::size_t retained_patterns = 64;
constexpr int rows = 3;
// In float, dependent rows of a net cannot be distinguished from nearly dependent ones. All rows
// get a small compliance, and each solve corrects the residual of the previous one (J. Carpentier
// et al., "Proximal and sparse resolution of constrained dynamic equations", 2021).
constexpr float net_compliance = 1e-2f;

// ---- groups ----

std::int32_t root_of(std::vector<std::int32_t>& parent, std::int32_t joint) {
    while (parent[as_index(joint)] != joint) {
        parent[as_index(joint)] = parent[as_index(parent[as_index(joint)])];
        joint = parent[as_index(joint)];
    }
    return joint;
}

// The first joint of each group is its root; the others are linked through `next` in order.
void merge_groups(JointBatches& batches, const JointLevels& levels,
                  std::span<const std::uint8_t> is_point, std::size_t bodies,
                  const JointSolverOptions& options) {
    const std::size_t joints = levels.joints.size();
    std::vector<std::int32_t>&parent = batches.parent, &first = batches.first;
    ASSERT(is_point.size() == joints);
    parent.resize(joints);
    first.assign(bodies, -1);  // by body: one of its joints
    for (std::size_t k = 0; k < joints; k++) {
        parent[k] = static_cast<std::int32_t>(k);
        if (is_point[k] == 0) continue;
        for (const std::int32_t hot : {levels.joints[k].a, levels.joints[k].b}) {
            if (hot <= 0) continue;
            if (first[as_index(hot)] < 0) first[as_index(hot)] = static_cast<std::int32_t>(k);
            const std::int32_t x = root_of(parent, first[as_index(hot)]);
            const std::int32_t y = root_of(parent, static_cast<std::int32_t>(k));
            parent[as_index(std::max(x, y))] = std::min(x, y);
        }
    }
    batches.next.assign(joints, -1);
    std::vector<std::int32_t>& last = batches.last;
    last.assign(joints, -1);
    batches.size.assign(joints, {});
    for (std::size_t k = 0; k < joints; k++) {
        if (is_point[k] == 0) continue;
        const auto joint = static_cast<std::int32_t>(k);
        const std::int32_t root = root_of(parent, joint);
        JointBatches::Size& size = batches.size[as_index(root)];
        ASSERT(root >= 0 && root <= joint);
        size.joints++;
        if (!options.preferences.empty()) size.preferences |= options.preferences[k];
        if (!options.locked.empty() && options.locked[k] != 0) size.locked = true;
        for (const std::int32_t hot : {levels.joints[k].a, levels.joints[k].b})
            if (hot > 0 && first[as_index(hot)] == joint) size.bodies++;
        if (last[as_index(root)] >= 0) batches.next[as_index(last[as_index(root)])] = joint;
        last[as_index(root)] = joint;
    }
}

// ---- patterns ----

// Assigns body numbers. A body that joints cannot push couples nothing and gets a separate number
// at each end.
struct BodyNumbering {
    std::vector<std::int32_t>& of_hot;  // -1 if not assigned
    std::vector<std::int32_t> hot;      // indexed by number
    std::vector<std::uint8_t> pushed;

    std::int32_t operator()(std::int32_t body) {
        if (body > 0 && of_hot[as_index(body)] >= 0) return of_hot[as_index(body)];
        const auto number = static_cast<std::int32_t>(hot.size());
        ASSERT(hot.size() == pushed.size());
        hot.push_back(std::abs(body));
        pushed.push_back(body > 0 ? 1 : 0);
        if (body > 0) of_hot[as_index(body)] = number;
        return number;
    }
};

void find_matrix(JointPattern& pattern, std::int64_t most) {
    const std::size_t joints = pattern.joints.size();
    BlockLdl matrix;
    pattern.max_work = most;
    const auto pushed = std::count(pattern.pushed.begin(), pattern.pushed.end(), 1);
    pattern.compliance =
        is_redundant(static_cast<int>(joints), static_cast<int>(pushed)) ? net_compliance : 0;
    // A row along a locked axis of the other body would have to wait for the hub. Compliance
    // applies to the sum of the responses of both bodies.
    const bool may_have_hubs = !pattern.locked && pattern.compliance == 0;
    pattern.hubs = {};
    pattern.hubs.split = true;
    pattern.too_dense = !find_joint_system_blocks(
        pattern.joints, std::vector<int>(joints, rows), pattern.pushed, most, matrix,
        pattern.system_blocks, may_have_hubs ? &pattern.hubs : nullptr);
    if (pattern.too_dense) return;
    pattern.work = matrix.work();
    ASSERT(pattern.work <= most);
    pattern.values = matrix.value_count();
    pattern.position.resize(joints);
    for (std::size_t k = 0; k < joints; k++)
        pattern.position[k] = matrix.position(static_cast<int>(k));
    pattern.negative.assign(as_index(matrix.nodes()), 0);
    for (const JointHub& hub : pattern.hubs.hubs)
        for (const int node : {hub.node, hub.node + 1})
            pattern.negative[as_index(matrix.position(node))] = 1;
    for (int at = 0; at < matrix.nodes(); at++) {
        pattern.diagonal.push_back(matrix.diagonal(at));
        pattern.first_below.push_back(static_cast<int>(pattern.below.size()));
        pattern.first_update.push_back(static_cast<int>(pattern.updates.size()));
        const auto below = matrix.below(at);
        const auto updates = matrix.updates(at);
        pattern.below.insert(pattern.below.end(), below.begin(), below.end());
        pattern.updates.insert(pattern.updates.end(), updates.begin(), updates.end());
        pattern.max_below = std::max(pattern.max_below, static_cast<int>(below.size()));
    }
    pattern.first_below.push_back(static_cast<int>(pattern.below.size()));
    pattern.first_update.push_back(static_cast<int>(pattern.updates.size()));
}

// Returns null if the factorisation takes more than `most` multiplications.
JointPattern* pattern_of(JointBatches& batches, const std::vector<std::uint8_t>& pushed,
                         bool locked, std::int64_t most) {
    std::unique_ptr<JointPattern>& found = batches.patterns[batches.key];
    if (found == nullptr) {
        found = std::make_unique<JointPattern>();
        found->pushed = pushed;
        found->locked = locked;
        for (std::size_t k = 0; k + 1 < batches.key.size(); k += 2) {
            const int a = batches.key[k] >> 1, b = batches.key[k + 1] >> 1;
            ASSERT(a != b && as_index(a) < pushed.size() && as_index(b) < pushed.size());
            found->joints.push_back({a, b});
        }
        find_matrix(*found, most);
    }
    found->used = batches.count;
    if (found->too_dense && most > found->max_work) find_matrix(*found, most);
    return found->too_dense || found->work > most ? nullptr : found.get();
}

void clear_patterns(JointBatches& batches) {
    if (batches.patterns.size() <= retained_patterns) return;
    std::erase_if(batches.patterns,
                  [&](const auto& entry) { return entry.second->used != batches.count; });
}

// ---- batches ----

// Maximum work of a factorisation of the group's matrix; 0: its joints are solved iteratively.
std::int64_t most_work_of(const JointBatches::Size& group, const JointSolverOptions& options) {
    const JointSolver solver = solver_of(group.preferences, options.of_world);
    if (solver == JointSolver::iterative) return 0;
    ASSERT(group.joints >= 1 && group.bodies >= 0);
    const bool target = solver == JointSolver::direct;
    // The iterative solver also solves a single point exactly.
    if (group.joints < 2 && !target) return 0;
    if (is_net(group.joints, group.bodies) && !(target && group.joints <= tuning::max_net_joints))
        return 0;
    return max_work(std::int64_t{group.joints} * rows * rows * rows, as_index(group.joints),
                    target ? options.budget : 0);
}

// Returns the batch of that pattern with a free lane, or a new one.
JointBatch& batch_of(JointBatches& batches, const JointPattern& pattern) {
    for (int k = batches.used - 1; k >= 0; k--) {
        JointBatch& batch = batches.all[as_index(k)];
        if (batch.pattern == &pattern) {
            if (batch.groups < 8) return batch;
            ASSERT(batch.groups == 8);
            break;
        }
    }
    if (as_index(batches.used) == batches.all.size()) batches.all.emplace_back();
    JointBatch& batch = batches.all[as_index(batches.used++)];
    batch.pattern = &pattern;
    batch.groups = 0;
    batch.joints.resize(pattern.joints.size());
    batch.bodies.resize(pattern.pushed.size());
    batch.values.resize(as_index(pattern.values));
    batch.column.resize(as_index(pattern.max_below) * rows * rows);
    batch.inverse.resize(pattern.diagonal.size() * 6);
    batch.unknown.resize(pattern.diagonal.size() * rows);
    for (BatchJoint& joint : batch.joints) {
        joint = {};
        std::fill(std::begin(joint.block), std::end(joint.block), -1);
    }
    for (BatchBody& body : batch.bodies) body = {};
    return batch;
}

}  // namespace

bool holds_point(const JointKind& kind) {
    if (const auto* fixed = std::get_if<FixedJoint>(&kind)) return fixed->linear.hertz == 0;
    return std::holds_alternative<BallJoint>(kind) || std::holds_alternative<HingeJoint>(kind) ||
           std::holds_alternative<ConeTwistJoint>(kind);
}

void find_batches(JointBatches& batches, JointLevels& levels,
                  std::span<const std::uint8_t> is_point, std::size_t bodies,
                  const JointSolverOptions& options) {
    ASSERT(is_point.size() == levels.joints.size());
    ASSERT(options.preferences.empty() || options.preferences.size() == levels.joints.size());
    batches.found.assign(levels.joints.size(), 0);
    batches.used = 0;
    batches.count++;
    ASSERT(options.locked.empty() || options.locked.size() == levels.joints.size());
    merge_groups(batches, levels, is_point, bodies, options);
    batches.first.assign(bodies, -1);
    for (std::size_t root = 0; root < levels.joints.size(); root++) {
        if (is_point[root] == 0 || batches.parent[root] != static_cast<std::int32_t>(root))
            continue;
        const std::int64_t most = most_work_of(batches.size[root], options);
        if (most == 0) continue;
        BodyNumbering number{batches.first, {}, {}};
        batches.key.clear();
        for (auto k = static_cast<std::int32_t>(root); k >= 0; k = batches.next[as_index(k)])
            for (const std::int32_t hot :
                 {levels.joints[as_index(k)].a, levels.joints[as_index(k)].b})
                batches.key.push_back(number(hot) * 2 + (hot > 0 ? 1 : 0));
        const bool locked = batches.size[root].locked;
        batches.key.push_back(locked ? 1 : 0);
        const JointPattern* const pattern = pattern_of(batches, number.pushed, locked, most);
        if (pattern == nullptr) continue;
        JointBatch& batch = batch_of(batches, *pattern);
        const auto lane = as_index(batch.groups++);
        ASSERT(lane < 8 && batch.bodies.size() == number.hot.size());
        for (std::size_t body = 0; body < batch.bodies.size(); body++)
            batch.bodies[body].hot[lane] = number.hot[body];
        std::size_t at = 0;
        for (auto k = static_cast<std::int32_t>(root); k >= 0; k = batches.next[as_index(k)]) {
            levels.metas[as_index(levels.joints[as_index(k)].block)].in_batch++;
            batches.found[as_index(k)] = 1;
            batch.joints[at].block[lane] = levels.joints[as_index(k)].block;
            ASSERT(at < batch.joints.size());
            batch.joints[at++].lane[lane] = levels.joints[as_index(k)].lane;
        }
    }
    for (JointConstraintWideMeta& meta : levels.metas)
        if (meta.in_batch == meta.count) meta.uses |= uses_batch;
    clear_patterns(batches);
}

BatchView view_of(JointBatch& batch, JointLevels& levels) {
    const JointPattern& pattern = *batch.pattern;
    ASSERT(batch.groups >= 1 && batch.groups <= 8);
    return {.groups = batch.groups,
            .joint_count = static_cast<int>(batch.joints.size()),
            .body_count = static_cast<int>(batch.bodies.size()),
            .node_count = static_cast<int>(pattern.diagonal.size()),
            .system_block_count = static_cast<int>(pattern.system_blocks.size()),
            .value_count = static_cast<int>(batch.values.size()),
            .joints = batch.joints.data(),
            .bodies = batch.bodies.data(),
            .values = batch.values.data(),
            .inverse = batch.inverse.data(),
            .unknown = batch.unknown.data(),
            .column = batch.column.data(),
            .ends = pattern.joints.data(),
            .pushed = pattern.pushed.data(),
            .system_blocks = pattern.system_blocks.data(),
            .hubs = pattern.hubs.hubs.data(),
            .hub_blocks = pattern.hubs.blocks.data(),
            .hub_count = static_cast<int>(pattern.hubs.hubs.size()),
            .hub_block_count = static_cast<int>(pattern.hubs.blocks.size()),
            .position = pattern.position.data(),
            .diagonal = pattern.diagonal.data(),
            .first_below = pattern.first_below.data(),
            .first_update = pattern.first_update.data(),
            .negative = pattern.negative.data(),
            .below = pattern.below.data(),
            .updates = pattern.updates.data(),
            .blocks = levels.blocks.data(),
            .compliance = pattern.compliance};
}

void load_batch(JointBatch& batch, const JointLevels& levels) {
    for (BatchJoint& joint : batch.joints)
        for (std::size_t lane = 0; lane < as_index(batch.groups); lane++) {
            const JointConstraintWide& from = levels.blocks[as_index(joint.block[lane])];
            const std::size_t at = as_index(joint.lane[lane]);
            ASSERT(at < 8 && joint.block[lane] >= 0);
            for (std::size_t axis = 0; axis < 3; axis++) {
                joint.arm_a[axis][lane] = from.arm_a[axis][at];
                joint.arm_b[axis][lane] = from.arm_b[axis][at];
                joint.apart[axis][lane] = from.apart[axis][at];
                joint.impulse[axis][lane] = from.point[axis][at];
            }
        }
}

}  // namespace jostle::physics
