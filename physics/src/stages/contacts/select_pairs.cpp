// SPDX-License-Identifier: MIT
#include "physics/src/stages/contacts/contact_stages.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/foundation/prefetch.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/separation_bounds.h"

namespace jostle::physics {
namespace {

void queue(ContactStore& store, ContactScratch& scratch, std::uint32_t contact) {
    Contact& c = store.contacts[contact];
    ASSERT(store.ids.alive(contact) && c.parent == none);
    if (c.queued) return;
    c.queued = true;
    scratch.tasks.push_back(
        {.contact = contact, .list = c.composite ? scratch.child_list_count++ : -1});
}

// Records which bodies have contacts, before anything changes: see stages/continuous/ccd_policy.h.
void note_contacts(const BodyStore& bodies, std::vector<std::uint8_t>& had_contacts) {
    had_contacts.clear();
    for (const BodyWarm& warm : bodies.awake)
        had_contacts.push_back(bodies.cold[warm.body].constraints > 0 ? 1 : 0);
}

// Pairs whose bodies are all asleep need no bound.
void drop_dormant_pairs(ContactStore& store) {
    if (!store.some_dormant) return;
    store.some_dormant = false;
    std::erase_if(store.bounds, [&](const SeparationBound& bound) {
        Contact& c = store.contacts[bound.contact];
        if (!c.dormant) return false;
        c.has_bound = false;
        c.limit = bound.limit;
        return true;
    });
}

// Removes the bounds that may be used up in this step from the list.
void select_due_pairs(StepContext& step) {
    WorldState& world = step.world;
    FlatArray<SeparationBound>& bounds = world.contacts.bounds;
    ContactScratch& scratch = step.scratch.contacts;
    std::vector<std::uint8_t>& due = scratch.due;
    due.resize(bounds.size());
    step.thread_pool.run(
        static_cast<int>(bounds.size()), tuning::bound_grain, [&](int begin, int end) {
            for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); k++)
                due[k] = is_due(world, world.def, bounds[k], step.dt) &&
                                 !renew_separation_bound(world, bounds[k], step.dt)
                             ? 1
                             : 0;
        });
    std::size_t retained = 0;
    for (std::size_t k = 0; k < bounds.size(); k++) {
        if (k + 8 < bounds.size() && due[k + 8] != 0)
            prefetch(world.contacts.contacts[bounds[k + 8].contact]);
        if (due[k] == 0) {
            bounds[retained++] = bounds[k];
            continue;
        }
        ASSERT(world.contacts.contacts[bounds[k].contact].has_bound);
        world.contacts.contacts[bounds[k].contact].has_bound = false;
        queue(world.contacts, scratch, bounds[k].contact);
    }
    bounds.resize(retained);
}

// A composite pair is tested as a whole if any of its children needs a rebuild.
void select_manifolds_to_rebuild(ContactStore& store, const ConstraintGraph& graph,
                                 ContactScratch& scratch) {
    const auto prefetch_contacts_of = [&](const ContactConstraintWideMeta& meta) {
        for (int lane = 0; lane < 8; lane++)
            if ((meta.bits(LaneFlag::needs_rebuild) >> lane & 1) != 0 && meta.contact[lane] != none)
                prefetch(store.contacts[meta.contact[lane]]);
    };
    for_each_colour(graph.sets, [&](const GraphColour& colour) {
        for (std::size_t k = 0; k < colour.metas.size(); k++) {
            if (k + 3 < colour.metas.size()) prefetch_contacts_of(colour.metas[k + 3]);
            const ContactConstraintWideMeta& meta = colour.metas[k];
            if (meta.bits(LaneFlag::needs_rebuild) == 0) continue;
            for (int lane = 0; lane < 8; lane++) {
                if ((meta.bits(LaneFlag::needs_rebuild) >> lane & 1) == 0 ||
                    meta.contact[lane] == none)
                    continue;
                const Contact& c = store.contacts[meta.contact[lane]];
                queue(store, scratch, c.parent == none ? meta.contact[lane] : c.parent);
            }
        }
    });
}

// A composite pair that is tested because of a child may still have a bound, which says nothing
// about the children. The narrow-phase test assigns a new one.
void drop_selected_bounds(ContactStore& store, const std::vector<NarrowPhaseTask>& tasks) {
    const auto has_bound = [&](const NarrowPhaseTask& task) {
        return store.contacts[task.contact].has_bound;
    };
    if (std::none_of(tasks.begin(), tasks.end(), has_bound)) return;
    std::erase_if(store.bounds, [&](const SeparationBound& bound) {
        return store.contacts[bound.contact].queued;
    });
    for (const NarrowPhaseTask& task : tasks) store.contacts[task.contact].has_bound = false;
}

// Reserves space for the results of the threads.
void make_space(ContactScratch& scratch) {
    const auto lists = static_cast<std::size_t>(scratch.child_list_count);
    ASSERT(lists <= scratch.tasks.size());
    if (scratch.children.size() < lists) scratch.children.resize(lists);
    scratch.fresh.reserve_discarding(scratch.tasks.size());
    scratch.fresh_count = 0;
}

}  // namespace

void select_pairs(StepContext& step) {
    WorldState& world = step.world;
    ContactScratch& scratch = step.scratch.contacts;
    scratch.tasks.clear();
    scratch.child_list_count = 0;
    note_contacts(world.bodies, scratch.had_contacts);
    scratch.bouncing.clear();
    drop_dormant_pairs(world.contacts);
    select_due_pairs(step);
    select_manifolds_to_rebuild(world.contacts, world.graph, scratch);
    drop_selected_bounds(world.contacts, scratch.tasks);
    make_space(scratch);
}

}  // namespace jostle::physics
