// SPDX-License-Identifier: MIT
#include "physics/src/constraint_graph/joint_levels.h"

#include <algorithm>
#include <array>
#include <type_traits>
#include <variant>

#include "jostle/base/check.h"
#include "jostle/physics/joint_defs.h"
#include "physics/src/constraint_graph/joint_memory.h"

namespace jostle::physics {
namespace {

bool has_row(std::uint32_t kind) {
    return kind == JointKind(VelocityRow{}).index();
}
template <class Kind>
constexpr bool is_of_axes = requires(Kind kind) {
    axes_of(kind);
};
// Indexed like JointKind.
template <class... Kinds>
constexpr std::array<bool, sizeof...(Kinds)> find_axes(std::type_identity<std::variant<Kinds...>>) {
    return {is_of_axes<Kinds>...};
}
bool has_axes(std::uint32_t kind) {
    static constexpr auto axes = find_axes(std::type_identity<JointKind>{});
    return kind < joint_kinds && axes[kind];
}
template <class... Kinds>
constexpr std::array<bool, sizeof...(Kinds)> find_geared_kinds(
    std::type_identity<std::variant<Kinds...>>) {
    return {is_geared<Kinds>...};
}
bool has_gear(std::uint32_t kind) {
    static constexpr auto gears = find_geared_kinds(std::type_identity<JointKind>{});
    return kind < joint_kinds && gears[kind];
}
bool has_angular(std::uint32_t kind) {
    return kind != JointKind(BallJoint{}).index() && !has_row(kind) && !has_axes(kind) &&
           !has_gear(kind);
}

// Returns the number of levels.
int find_levels(JointLevels& levels, std::size_t bodies) {
    ASSERT(std::is_sorted(
        levels.joints.begin(), levels.joints.end(),
        [](const LeveledJoint& x, const LeveledJoint& y) { return x.joint < y.joint; }));
    levels.reached.assign(bodies, 0);
    std::uint32_t count = 0;
    const auto reached = [&](std::int32_t hot) -> std::uint32_t& {
        ASSERT(hot < static_cast<std::int32_t>(levels.reached.size()));
        return levels.reached[static_cast<std::size_t>(std::max(hot, 0))];
    };
    for (LeveledJoint& joint : levels.joints) {
        ASSERT(joint.kind < kernel_kinds);
        ASSERT(joint.a != joint.b);
        std::uint32_t level = std::max(reached(joint.a), reached(joint.b));
        if ((joint.carrier_a | joint.carrier_b) != 0) {
            level = std::max({level, reached(joint.carrier_a), reached(joint.carrier_b)});
            reached(joint.carrier_a) = reached(joint.carrier_b) = level + 1;
        }
        reached(joint.a) = reached(joint.b) = level + 1;
        levels.reached[0] = 0;  // immovable bodies do not order joints
        count = std::max(count, level + 1);
        joint.run = level * kernel_kinds + joint.kind;
    }
    return static_cast<int>(count);
}

}  // namespace

void assign_levels(JointLevels& levels, std::size_t bodies) {
    const int count = find_levels(levels, bodies);
    levels.next_lanes.assign(static_cast<std::size_t>(count) * kernel_kinds, 0);
    for (const LeveledJoint& joint : levels.joints) levels.next_lanes[joint.run]++;
    levels.runs.clear();
    int blocks = 0, angular = 0, rows = 0, axes = 0, gears = 0;
    for (std::uint32_t key = 0; key < levels.next_lanes.size(); key++) {
        const int joints = levels.next_lanes[key];
        levels.next_lanes[key] = blocks * 8;  // the next free lane
        if (joints == 0) continue;
        const std::uint32_t kind = key % kernel_kinds;
        const int size = (joints + 7) / 8;
        levels.runs.push_back({.kind = static_cast<std::uint8_t>(kind),
                               .begin = blocks,
                               .end = blocks + size,
                               .angular = has_angular(kind) ? angular : -1,
                               .row = has_row(kind) ? rows : -1,
                               .axes = has_axes(kind) ? axes : -1,
                               .gear = has_gear(kind) ? gears : -1});
        blocks += size;
        if (has_angular(kind)) angular += size;
        if (has_row(kind)) rows += size;
        if (has_axes(kind)) axes += size;
        if (has_gear(kind)) gears += size;
    }
    levels.metas.assign(static_cast<std::size_t>(blocks), {});
    for (const JointRun& run : levels.runs)
        for (int k = run.begin; k < run.end; k++) {
            JointConstraintWideMeta& meta = levels.metas[static_cast<std::size_t>(k)];
            meta.angular = run.angular < 0 ? -1 : run.angular + k - run.begin;
            meta.row = run.row < 0 ? -1 : run.row + k - run.begin;
            meta.axes = run.axes < 0 ? -1 : run.axes + k - run.begin;
            meta.gear = run.gear < 0 ? -1 : run.gear + k - run.begin;
        }
    for (LeveledJoint& joint : levels.joints) {
        const int lane = levels.next_lanes[joint.run]++;
        JointConstraintWideMeta& meta = levels.metas[static_cast<std::size_t>(lane / 8)];
        ASSERT(meta.count < 8);
        joint.block = lane / 8;
        ASSERT(lane % 8 == meta.count);
        joint.lane = meta.count;
        meta.joint[meta.count] = joint.joint;
        ASSERT(joint.a != joint.b);
        meta.a[meta.count] = joint.a;
        meta.b[meta.count] = joint.b;
        meta.count++;
    }
    levels.blocks.assign(static_cast<std::size_t>(blocks), JointConstraintWide{});
    levels.angular.assign(static_cast<std::size_t>(angular), JointAngularWide{});
    levels.rows.assign(static_cast<std::size_t>(rows), VelocityRowWide{});
    levels.axes.assign(static_cast<std::size_t>(axes), JointAxesWide{});
    levels.gears.assign(static_cast<std::size_t>(gears), JointGearWide{});
}

}  // namespace jostle::physics
