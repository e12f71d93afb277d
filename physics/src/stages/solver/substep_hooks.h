// SPDX-License-Identifier: MIT
//
// External effects in a sub-step: listeners and force fields. They act on solved bodies through the
// hot records, and on free bodies through the double motions of integrate_free.
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
// If concurrent, there is one group per colour set, and free bodies are split into chunks.
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

// Calls all sub-step listeners on this thread. `hot`: hot indices of the bodies of a solver task.
// Their colour sets are [first, last).
void call_listeners(StepContext& step, const SubstepInfo& substep_info,
                    std::span<const std::uint32_t> hot, std::size_t first, std::size_t last);
// Same for free bodies: awake indices and current motions. `first_free_index`: index of the first
// one among all free bodies.
void call_listeners(StepContext& step, const SubstepInfo& substep_info,
                    std::span<const std::uint32_t> awake, std::span<BodyWarm> moving,
                    std::uint32_t first_free_index, ListenedGroup& group);

// Appends the bodies that a field may reach within the step, at their velocities at its start, to
// `found`.
void find_in_fields(const StepContext& step, std::span<const std::uint32_t> hot,
                    std::vector<std::uint32_t>& found);
// Applies the force fields to solved bodies in a sub-step.
void push_by_fields(StepContext& step, const SubstepInfo& substep_info,
                    std::span<const std::uint32_t> hot);

}  // namespace jostle::physics
