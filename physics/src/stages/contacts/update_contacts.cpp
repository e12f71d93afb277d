// SPDX-License-Identifier: MIT
#include "physics/src/stages/stages.h"

#include <cstddef>

#include "physics/src/foundation/prefetch.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/contacts/contact_stages.h"
#include "physics/src/stages/step_scratch.h"

namespace jostle::physics {
namespace {

// Contacts, their bodies and shapes are scattered in memory. Prefetches them in the order of their
// references, several tasks ahead.
void prefetch_ahead(const ContactGraph& stores, const std::vector<NarrowPhaseTask>& tasks, int k,
                    int end) {
    const auto contact_of = [&](int task) -> const Contact& {
        return stores.contacts.contacts[tasks[static_cast<std::size_t>(task)].contact];
    };
    if (k + 12 < end) prefetch(contact_of(k + 12));
    if (k + 8 < end) {
        const Contact& c = contact_of(k + 8);
        for (const std::uint32_t body : {c.body_a, c.body_b})
            prefetch(stores.bodies.cold[body], offsetof(BodyCold, local_center));
        for (const std::uint32_t shape : {c.shape_a, c.shape_b})
            prefetch(stores.shapes.shapes[shape]);
    }
    if (k + 4 < end) {
        const Contact& c = contact_of(k + 4);
        for (const std::uint32_t body : {c.body_a, c.body_b}) prefetch(warm_of(stores, body));
    }
}

}  // namespace

Skipped update_contacts(StepContext& step) {
    if (step.world.bodies.awake.empty()) return no_awake_bodies;
    select_pairs(step);
    std::vector<NarrowPhaseTask>& tasks = step.scratch.contacts.tasks;
    step.thread_pool.run(static_cast<int>(tasks.size()), tuning::narrow_phase_grain,
                         [&](int begin, int end) {
                             for (int k = begin; k < end; k++) {
                                 NarrowPhaseTask& task = tasks[static_cast<std::size_t>(k)];
                                 prefetch_ahead(step.world, tasks, k, end);
                                 if (is_stopped(step))
                                     task.done = true;  // unchanged
                                 else
                                     narrow_phase_pair(step, task);
                             }
                         });
    update_touching(step);
    step.world.profile.pairs_checked = static_cast<int>(tasks.size());
    step.world.profile.composites_checked = step.scratch.contacts.child_list_count;
    return ran;
}

}  // namespace jostle::physics
