// SPDX-License-Identifier: MIT
//
// The inner loops of the solver, built once per instruction set and selected at run time. All
// variants produce the same bits (see math/wide.h), so the selection is not part of a world's
// state.
#pragma once

#include <cstdint>

#include "jostle/physics/instruction_set.h"
#include "physics/src/constraint_graph/constraint_graph.h"
#include "physics/src/constraint_graph/gyroscopic_wide.h"
#include "physics/src/constraint_graph/joint_constraint_wide.h"
#include "physics/src/constraint_graph/solver_body.h"
#include "physics/src/constraints/contact_settings.h"
#include "physics/src/constraints/joints/joint_step.h"

namespace jostle::physics {

// A range of blocks of one colour. Blocks of a colour may be solved in any order, blocks of an
// overflow list only serially.
struct ContactRange {
    ContactConstraintWide* blocks;
    ContactConstraintWideMeta* metas;
    RestitutionWide* restitutions;
    RollingWide* rollings;
    int begin, end;
    PairKind pair;
    bool single;      // single-point manifolds
    bool one_by_one;  // an overflow list
};

// A range of bodies by hot index.
struct BodyRange {
    SolverBody* bodies;
    const ExternalChange* external;
    const std::uint32_t* indices;
    int begin, end;
};

// A range of blocks of one run of joints.
struct JointRange {
    JointConstraintWide* blocks;
    JointAngularWide* angular;  // of the run's first block; null for kinds without it
    VelocityRowWide* rows;      // same
    JointAxesWide* axes;        // same
    JointGearWide* gears;       // same
    const JointConstraintWideMeta* metas;
    int kind;   // index into JointKind
    int first;  // first block of the run
    int begin, end;
};

struct BatchView;  // constraints/joints/joint_batches.h

using JointPass = void (*)(const JointRange&, SolverBody*, const JointStep&);
using BatchKernel = void (*)(const BatchView&, SolverBody*, const JointStep&);
using GyroscopicPass = void (*)(const GyroscopicRange&, SolverBody*, float h);
using ContactPass = void (*)(const ContactRange&, SolverBody*, const ContactSettings&);

struct Kernels {
    ContactPass warm_start, solve, relax;
    // relax_last ends the step: it sets `needs_rebuild` and `touching_now` of every block.
    ContactPass relax_last;
    ContactPass begin_restitution, predict_approach, record_peaks, apply_restitution;
    // accelerate_first does not warm-start contacts.
    void (*accelerate_first)(const BodyRange&);
    void (*accelerate)(const BodyRange&);
    void (*advance)(const BodyRange&, float h);
    // Euler's equations in a sub-step of h: for bodies without joints, and before and after the
    // last pass over the points of joints.
    GyroscopicPass spin_freely, begin_gyroscopic, end_gyroscopic;
    JointPass warm_start_joints, solve_joints, relax_joints;
    // Batches of directly solved groups. factor_batch reads the current poses; the others solve
    // velocities. solve_batch_again runs after contacts have changed the velocities.
    void (*factor_batch)(const BatchView&, const SolverBody*, const JointStep&);
    BatchKernel solve_batch, solve_batch_again, relax_batch;
    // Called before and after the joint passes for the bodies with joints.
    void (*begin_joints)(const BodyRange&);
    void (*end_joints)(const BodyRange&);
};

// The kernels of the active instruction set (jostle/physics/instruction_set.h).
const Kernels& kernels();

namespace scalar {
extern const Kernels table;
}
namespace baseline {
extern const Kernels table;
}
#if defined(__x86_64__)
// x86-64 has a baseline table only under a sanitizer and in a portable build: SSE2 cannot fuse.
namespace avx2 {
extern const Kernels table;
}
namespace avx512 {
extern const Kernels table;
}
// The contact passes, two blocks at a time.
namespace avx512_two {
void solve(const ContactRange&, SolverBody*, const ContactSettings&);
void relax(const ContactRange&, SolverBody*, const ContactSettings&);
void relax_last(const ContactRange&, SolverBody*, const ContactSettings&);
}  // namespace avx512_two
#endif

}  // namespace jostle::physics
