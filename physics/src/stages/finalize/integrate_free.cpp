// SPDX-License-Identifier: MIT
#include "stages/finalize/integrate_free.h"

#include "foundation/check.h"
#include "foundation/tuning.h"

#include "constraints/free_motion.h"
#include "stages/finalize/finalize_body.h"
#include "stages/step_scratch.h"

namespace jostle::physics {

Skipped integrate_free(StepContext& step) {
    if (step.world.bodies.awake.empty()) return nobody_awake;
    WorldState& world = step.world;
    const auto& free = step.scratch.solver.free;
    begin_finalize(world.bodies, step.scratch.finalize);
    step.team.run(static_cast<int>(free.size()), tuning::body_grain, [&](int begin, int end) {
        for (int k = begin; k < end; k++) {
            const std::uint32_t i = free[static_cast<std::size_t>(k)];
            ASSERT(i < world.bodies.awake.size());
            const BodyWarm& warm = world.bodies.awake[i];
            finalize_body(
                step, i,
                free_motion(warm, world.bodies.cold[warm.body], world.def.gravity, step.dt));
        }
    });
    return ran;
}

}  // namespace jostle::physics
