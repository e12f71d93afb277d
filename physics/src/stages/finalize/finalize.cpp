// SPDX-License-Identifier: MIT
#include "physics/src/stages/stages.h"

#include "jostle/base/check.h"
#include "physics/src/foundation/tuning.h"

#include "physics/src/stages/finalize/finalize_body.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/shape_proxy.h"

namespace jostle::physics {
namespace {

FreeMotion motion_of(const SolverScratch& solver, std::size_t hot_index, const BodyWarm& warm) {
    const SolverBody& hot = solver.hot[hot_index];
    const Quat turn = from_rotation_vector(to_vec3(hot.dr));
    return {to_vec3(hot.dp), normalized(turn * warm.rotation), to_vec3(hot.v),
            solver.spin_axes[hot_index] == SpinAxes::body ? rotate(turn, to_vec3(hot.w))
                                                          : to_vec3(hot.w)};
}

}  // namespace

Skipped finalize(StepContext& step) {
    if (step.world.bodies.awake.empty()) return no_awake_bodies;
    WorldState& world = step.world;
    const SolverScratch& solver = step.scratch.solver;
    FinalizeScratch& scratch = step.scratch.finalize;
    // Kinematic bodies were finalized together with the free ones, because contacts do not move
    // them.
    const std::vector<std::uint32_t>& solved = solver.bodies.all;
    ASSERT(solved.empty() || solver.hot.size() == world.bodies.awake.size() + 1);
    step.thread_pool.run(
        static_cast<int>(solved.size()), tuning::body_grain, [&](int begin, int end) {
            for (int k = begin; k < end; k++) {
                const std::uint32_t i = solved[static_cast<std::size_t>(k)] - 1;
                finalize_body(step, i, motion_of(solver, i + 1, world.bodies.awake[i]));
            }
        });
    for (std::size_t i = 0; i < scratch.on_path.size(); i++)
        if (scratch.on_path[i] != 0) scratch.path_bodies.push_back(world.bodies.awake[i].body);
    // In the order of the awake set.
    ASSERT(scratch.left_fat_aabb.size() == world.bodies.awake.size());
    auto& moves = scratch.moves;
    moves.clear();
    for (std::uint32_t i = 0; i < world.bodies.awake.size(); i++) {
        if (scratch.left_fat_aabb[i] == 0) continue;
        const std::uint32_t body = world.bodies.awake[i].body;
        for (std::uint32_t s = world.bodies.cold[body].first_shape; s != none;
             s = world.shapes.shapes[s].next) {
            const ShapeRecord& shape = world.shapes.shapes[s];
            ASSERT(shape.leaf >= 0 || is_plane(shape));
            if (shape.leaf >= 0) moves.push_back({shape.leaf, shape.fat});
            buffer_move(world.shapes, world.triggers, s);
        }
    }
    const auto update_trees = [&shapes = world.shapes, &moves] {
        shapes.moving->move_all(moves);
        shapes.moving->flush();
    };
    // The trees are not queried before the sweeps. A few moves take less time than waking a thread.
    if (moves.size() >= tuning::async_moves_min)
        step.thread_pool.start(update_trees);
    else if (!moves.empty())
        update_trees();
    return ran;
}

}  // namespace jostle::physics
