// SPDX-License-Identifier: MIT
//
// What acts in a sub-step from outside: listeners and force fields. Of bodies in the solver by
// their hot records, of free bodies by motions in double that integrate_free keeps.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/src/stages/solver/solver_scratch.h"
#include "physics/src/stages/step_context.h"

namespace jostle::physics {

inline bool has_substep_listeners(const ListenerStore& listeners) {
    return listeners.active_hooks.substeps;
}
// Groups are then one a colour set, and chunks of free bodies.
inline bool listens_at_once(const ListenerStore& listeners) {
    return listeners.active_hooks.substeps && listeners.active_hooks.concurrent;
}
inline bool listens_on_one_thread(const ListenerStore& listeners) {
    return listeners.active_hooks.substeps && !listeners.active_hooks.concurrent;
}

// A sub-step of a group of bodies.
struct SubstepInfo {
    int index, count;
    double h;  // s
    bool after = false;
};

// Calls every listener that wants sub-steps, on this thread. The bodies of a task of the solver, by
// hot index; their colour sets are [first, last).
void call_listeners(StepContext& step, const SubstepInfo& substep_info,
                    std::span<const std::uint32_t> hot, std::size_t first, std::size_t last);
// ... of free bodies: awake indices and how each moves now; the first one's place among all free
// ones.
void call_listeners(StepContext& step, const SubstepInfo& substep_info,
                    std::span<const std::uint32_t> awake, std::span<BodyWarm> moving,
                    std::uint32_t first_free_index, ListenedGroup& group);

// Adds to `found` those whom a field may reach within the step, by their velocity as it begins.
void find_in_fields(const StepContext& step, std::span<const std::uint32_t> hot,
                    std::vector<std::uint32_t>& found);
// What the force fields do in a sub-step to bodies of the solver.
void push_by_fields(StepContext& step, const SubstepInfo& substep_info,
                    std::span<const std::uint32_t> hot);

}  // namespace jostle::physics
