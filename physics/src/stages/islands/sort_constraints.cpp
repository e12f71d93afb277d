// SPDX-License-Identifier: MIT
#include "physics/src/stages/islands/island_stages.h"

#include "physics/src/state/contact_constraints.h"

namespace jostle::physics {

void sort_constraints(StepContext& step) {
    for (ColourSet& set : step.world.graph.solved()) {
        if (!is_shared(set)) continue;
        step.thread_pool.run_tasks(overflow_colours, [&](int c) {
            GraphColour& colour = set.colours[static_cast<std::size_t>(c)];
            if (!is_sorted(colour)) sort_contacts(step.world.contacts, colour, c);
        });
    }
}

}  // namespace jostle::physics
