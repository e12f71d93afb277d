// SPDX-License-Identifier: MIT
#include "stages/sort_constraints.h"

#include "state/lanes.h"

namespace jostle::physics {

void sort_constraints(StepContext& step) {
    for (ColourSet& set : solved_sets(step.world.graph)) {
        if (!is_shared(set)) continue;
        step.team.run_tasks(overflow_colours, [&](int c) {
            Colour& colour = set.colours[static_cast<std::size_t>(c)];
            if (!in_order(colour)) sort_lanes(step.world, colour, c);
        });
    }
}

}  // namespace jostle::physics
