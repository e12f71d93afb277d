// SPDX-License-Identifier: MIT
#include "physics/src/stages/solver/warm_start_cache.h"

#include <gtest/gtest.h>

#include "jostle/physics/joint_fields.h"
#include "physics/src/constraint_graph/joint_memory.h"

namespace jostle::test {
namespace {
using namespace physics;

// Each kind's own fields come back, whichever way they are kept.
TEST(WarmStartCache, round_trip) {
    const Quat carried = normalized(Quat{0.3, -0.2, 0.5, 0.7});
    for_each_joint_kind([&](const auto& kind) {
        Joint joint;
        joint.kind = kind;
        joint.memory.assign(memory_of(joint.kind), 0);
        // Gears have no such fields; joint_groups.cpp stores where they and paths are.
        if (!supported(joint.kind) || joint_is_geared(joint.kind)) return;
        if (std::holds_alternative<PathJoint>(joint.kind)) joint.memory.resize(PathMemory::found);
        joint.point = {1, -2, 3};
        joint.angular = {0.5, 0.25, -1};
        joint.lower = 1, joint.upper = 2, joint.spring = 3, joint.motor = 4, joint.swing = 5;
        for (std::size_t k = 0; k < joint.memory.size(); k++)
            joint.memory[k] = static_cast<double>(k) + 1;
        const WarmStartCache kept = read_warm_start(joint, carried);
        Joint after = joint;
        after.point = after.angular = {};
        after.lower = after.upper = after.spring = after.motor = after.swing = 0;
        after.memory.assign(joint.memory.size(), 0);
        write_warm_start(after, carried, kept);
        const char* const name = kind_name(joint.kind);
        EXPECT_LT(length(after.point - joint.point), 1e-12) << name;
        EXPECT_LT(length(after.angular - joint.angular), 1e-12) << name;
        EXPECT_EQ(after.memory, joint.memory) << name;
        if (!joint.memory.empty()) return;
        EXPECT_EQ(after.lower, 1) << name;
        EXPECT_EQ(after.upper, 2) << name;
        EXPECT_EQ(after.spring, 3) << name;
        EXPECT_EQ(after.motor, 4) << name;
        EXPECT_EQ(after.swing, 5) << name;
    });
}

}  // namespace
}  // namespace jostle::test
