// SPDX-License-Identifier: MIT
#include "physics/src/stages/solver/integrate_gyroscopic.h"

#include <algorithm>

#include "physics/src/constraints/free_motion.h"
#include "physics/src/constraints/kernels.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/step_scratch.h"

namespace jostle::physics {
namespace {

void write_body(const StepContext& step, std::uint32_t hot_index, GyroscopicWide& block, int lane) {
    const SolverScratch& scratch = step.scratch.solver;
    const BodyWarm& warm = step.world.bodies.awake[hot_index - 1];
    const PrincipalAxes& axes = step.world.bodies.cold[warm.body].principal;
    const Vec3 bend = bend_of(axes),
               inverse{1 / axes.moments.x, 1 / axes.moments.y, 1 / axes.moments.z};
    const Quat frame = warm.rotation * axes.frame;
    block.hot[lane] = static_cast<std::int32_t>(hot_index);
    const bool by_substeps = scratch.spin_axes[hot_index] == SpinAxes::world_by_substeps;
    block.by_substeps[lane] = by_substeps ? 1 : 0;
    const double at[] = {frame.x, frame.y, frame.z, frame.w};
    for (int k = 0; k < 4; k++) block.principal[k][lane] = as_float(at[k]);
    for (int k = 0; k < 3; k++) {
        block.bend[k][lane] = as_float(bend[k]);
        block.inverse_moments[k][lane] = as_float(inverse[k]);
    }
}

void write_blocks(StepContext& step, const std::vector<std::uint32_t>& hot,
                  std::vector<GyroscopicWide>& blocks) {
    constexpr std::size_t lanes = 8;
    blocks.resize((hot.size() + lanes - 1) / lanes);
    step.thread_pool.run(
        static_cast<int>(blocks.size()), tuning::body_grain / 8, [&](int begin, int end) {
            for (int k = begin; k < end; k++) {
                GyroscopicWide& block = blocks[static_cast<std::size_t>(k)];
                block = {};
                std::fill_n(block.principal[3], lanes, 1.0f);
                std::fill_n(block.turned[3], lanes, 1.0f);
                for (std::size_t lane = 0; lane < lanes; lane++) {
                    const std::size_t at = static_cast<std::size_t>(k) * lanes + lane;
                    if (at < hot.size()) write_body(step, hot[at], block, static_cast<int>(lane));
                }
            }
        });
}

void run(StepContext& step, GyroscopicPass pass, std::vector<GyroscopicWide>& blocks, double h) {
    step.thread_pool.run(
        static_cast<int>(blocks.size()), tuning::body_grain / 8, [&](int begin, int end) {
            pass({blocks.data(), begin, end}, step.scratch.solver.hot.data(), as_float(h));
        });
}

}  // namespace

void find_gyroscopic(StepContext& step, std::span<const std::uint32_t> bodies,
                     GyroscopicBodies& found) {
    const SolverScratch& scratch = step.scratch.solver;
    const BodyStore& store = step.world.bodies;
    for (std::vector<std::uint32_t>& list : found.hot) list.clear();
    for (const std::uint32_t index : bodies) {
        if (scratch.spin_axes[index] == SpinAxes::world) continue;
        const BodyCold& cold = store.cold[store.awake[index - 1].body];
        found.hot[cold.first_joint != none ? 0 : 1].push_back(index);
    }
    write_blocks(step, found.hot[0], found.jointed);
    write_blocks(step, found.hot[1], found.others);
}

void begin_gyroscopic(StepContext& step, GyroscopicBodies& bodies, double h) {
    run(step, kernels().begin_gyroscopic, bodies.jointed, h);
}

void end_gyroscopic(StepContext& step, GyroscopicBodies& bodies, double h) {
    run(step, kernels().end_gyroscopic, bodies.jointed, h);
    run(step, kernels().spin_freely, bodies.others, h);
}

}  // namespace jostle::physics
