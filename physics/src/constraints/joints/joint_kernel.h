// SPDX-License-Identifier: MIT
//
// The passes over blocks of joints, and over the bodies of joints.
#pragma once

#include <type_traits>
#include <variant>

#include "physics/src/constraint_graph/joint_memory.h"
#include "physics/src/constraints/joints/joint_kinds.h"
#include "physics/src/constraints/kernels.h"

namespace jostle::physics::JOSTLE_ISA {

// Calls pass(kernel) with the kernel of the range's kind.
template <class Pass, class... Kinds>
JOSTLE_INLINE void with_kind(int kind, Pass pass, std::type_identity<std::variant<Kinds...>>) {
    int index = 0;
    static_cast<void>(((index++ == kind && (pass(JointKernel<Kinds>{}), true)) || ...));
}
template <class Pass>
JOSTLE_INLINE void with_kind(int kind, Pass pass) {
    if (kind == static_cast<int>(driven_ball)) return pass(JointKernel<DrivenBall>{});
    if (kind == static_cast<int>(limited_hinge)) return pass(JointKernel<HingeJoint>{});
    with_kind(kind, pass, std::type_identity<JointKind>{});
}

// The kind-specific data of a block. Ball joints have none.
JOSTLE_INLINE JointAngularWide& own_of(const JointRange& range, int block,
                                       JointAngularWide& nothing) {
    return range.angular == nullptr ? nothing : range.angular[block - range.first];
}
JOSTLE_INLINE VelocityRowWide& own_of(const JointRange& range, int block, VelocityRowWide&) {
    return range.rows[block - range.first];
}
JOSTLE_INLINE JointAxesWide& own_of(const JointRange& range, int block, JointAxesWide&) {
    return range.axes[block - range.first];
}

inline void warm_start_joint_range(const JointRange& range, SolverBody* bodies, const JointStep&) {
    with_kind(range.kind, [&](auto kernel) {
        using Own = typename decltype(kernel)::Own;
        if constexpr (std::is_same_v<Own, JointGearWide>) {
            for (int k = range.begin; k < range.end; k++)
                GearKernel::warm_start(range.gears[k - range.first], bodies);
        } else {
            Own nothing;
            for (int k = range.begin; k < range.end; k++) {
                JointPair pair(range.blocks[k], bodies);
                kernel.warm_start(pair, range.blocks[k], own_of(range, k, nothing),
                                  range.metas[k].uses);
                pair.store();
            }
        }
    });
}

// kLoads: adds the loads of the sub-step.
template <bool kRelax, bool kLoads>
void solve_joint_range(const JointRange& range, SolverBody* bodies, const JointStep& step) {
    with_kind(range.kind, [&](auto kernel) {
        using Own = typename decltype(kernel)::Own;
        if constexpr (std::is_same_v<Own, JointGearWide>) {
            for (int k = range.begin; k < range.end; k++) {
                JointGearWide& own = range.gears[k - range.first];
                const JointLoad load = GearKernel::solve<kRelax>(step, own, bodies);
                if constexpr (kLoads) {
                    JointConstraintWide& block = range.blocks[k];
                    store3(block.force, load3(block.force) + load.impulse);
                    store3(own.torque, load3(own.torque) + load.angular);
                }
            }
        } else {
            Own nothing;
            for (int k = range.begin; k < range.end; k++) {
                JointConstraintWide& block = range.blocks[k];
                auto& own = own_of(range, k, nothing);
                JointPair pair(block, bodies);
                const JointLoad load =
                    kernel.template solve<kRelax>(pair, step, block, own, range.metas[k].uses);
                pair.store();
                if constexpr (kLoads) {
                    store3(block.force, load3(block.force) + load.impulse);
                    if (&own != &nothing) store3(own.torque, load3(own.torque) + load.angular);
                }
            }
        }
    });
}

// Velocity changes between these two calls count as non-contact changes: accelerate() then
// warm-starts contacts with the contact impulses only. Joints warm-start themselves along their
// current directions.
inline void begin_joints_range(const BodyRange& range) {
    for (int k = range.begin; k < range.end; k++) {
        SolverBody& hot = range.bodies[range.indices[k]];
        store(hot.free, load(hot.free) - load(hot.v));
    }
}
inline void end_joints_range(const BodyRange& range) {
    for (int k = range.begin; k < range.end; k++) {
        SolverBody& hot = range.bodies[range.indices[k]];
        store(hot.free, load(hot.free) + load(hot.v));
    }
}

}  // namespace jostle::physics::JOSTLE_ISA
