// SPDX-License-Identifier: MIT
//
// The inner loops of the solver, built once per instruction set and chosen at run time. All give
// the same bits (math/wide.h says why), so the choice is not part of a world's state.
#pragma once

#include <cstdint>

#include "jostle/physics/instruction_set.h"
#include "physics/src/constraint_graph/constraint_graph.h"
#include "physics/src/constraint_graph/joint_constraint_wide.h"
#include "physics/src/constraint_graph/solver_body.h"
#include "physics/src/constraints/contact_settings.h"
#include "physics/src/constraints/joints/joint_step.h"

namespace jostle::physics {

// Some blocks of one colour. Blocks of a colour may be solved in any order, those of an overflow
// list only one after the other.
struct ContactRange {
    ContactConstraintWide* blocks;
    ContactConstraintWideMeta* metas;
    RestitutionWide* restitutions;
    RollingWide* rollings;
    int begin, end;
    PairKind pair;
    bool single;      // manifolds of one point
    bool one_by_one;  // an overflow list
};

// Some bodies by hot index.
struct BodyRange {
    SolverBody* bodies;
    const ExternalChange* external;
    const std::uint32_t* indices;
    int begin, end;
};

// Some blocks of one run of joints.
struct JointRange {
    JointConstraintWide* blocks;
    JointAngularWide* angular;  // of the run's first block; null for kinds that have none
    VelocityRowWide* rows;      // likewise
    JointAxesWide* axes;        // likewise
    JointGearWide* gears;       // likewise
    const JointConstraintWideMeta* metas;
    int kind;   // index into JointKind
    int first;  // block of the run
    int begin, end;
};

struct BatchView;  // constraints/joints/joint_batches.h

using JointPass = void (*)(const JointRange&, SolverBody*, const JointStep&);
using BatchKernel = void (*)(const BatchView&, SolverBody*, const JointStep&);
using ContactPass = void (*)(const ContactRange&, SolverBody*, const ContactSettings&);

struct Kernels {
    ContactPass warm_start, solve, relax;
    ContactPass
        relax_last;  // ends the step: sets `needs_rebuild` and `touching_now` of every block
    ContactPass begin_restitution, predict_approach, record_peaks, apply_restitution;
    // The first sub-step's takes no warm start from what contacts did in the one before.
    void (*accelerate_first)(const BodyRange&);
    void (*accelerate)(const BodyRange&);
    void (*advance)(const BodyRange&, float h);
    JointPass warm_start_joints, solve_joints, relax_joints;
    // Batches of groups that are solved at once: where the bodies are, then velocities.
    // (again: after contacts have changed them).
    void (*factor_batch)(const BatchView&, const SolverBody*, const JointStep&);
    BatchKernel solve_batch, solve_batch_again, relax_batch;
    // Around the passes of joints, for the bodies that have some.
    void (*begin_joints)(const BodyRange&);
    void (*end_joints)(const BodyRange&);
};

// Of the instruction set in use (jostle/physics/instruction_set.h).
const Kernels& kernels();

namespace scalar {
extern const Kernels table;
}
namespace baseline {
extern const Kernels table;
}
#if defined(__x86_64__)
// x86-64 has no baseline but under a sanitizer and in a portable build: SSE2 cannot fuse.
namespace avx2 {
extern const Kernels table;
}
namespace avx512 {
extern const Kernels table;
}
// The passes over contacts, two blocks at a time.
namespace avx512_two {
void solve(const ContactRange&, SolverBody*, const ContactSettings&);
void relax(const ContactRange&, SolverBody*, const ContactSettings&);
void relax_last(const ContactRange&, SolverBody*, const ContactSettings&);
}  // namespace avx512_two
#endif

}  // namespace jostle::physics
