// SPDX-License-Identifier: MIT
#include "physics/src/stages/stages.h"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <vector>

#include "jostle/base/check.h"
#include "physics/src/constraints/write_manifold.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/contacts/call_contact_listeners.h"
#include "physics/src/stages/islands/island_stages.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/contact_graph.h"
#include "physics/src/state/island_tiers.h"

namespace jostle::physics {
namespace {

// Adds the heavier body if it is much heavier.
void note_heavy(const BodyStore& bodies, const Contact& c, std::vector<std::uint32_t>& heavy) {
    const double a = bodies.cold[c.body_a].mass, b = bodies.cold[c.body_b].mass;
    if (maximum(a, b) >= tuning::direct_load_ratio * minimum(a, b))
        heavy.push_back(a > b ? c.body_a : c.body_b);
}

}  // namespace

// In order of shapes, so that colours and slots do not depend on the order of the bounds.
Skipped begin_contacts(StepContext& step) {
    WorldState& world = step.world;
    ContactScratch& scratch = step.scratch.contacts;
    std::vector<NewContact>& begins = scratch.begins;
    if (world.bodies.awake.empty()) return no_awake_bodies;
    if (begins.empty()) return "no new manifolds";
    const auto key = [&](const NewContact& next) {
        const Contact& c = world.contacts.contacts[scratch.tasks[next.task].contact];
        return std::tuple(c.shape_a, c.shape_b, next.child);
    };
    std::sort(begins.begin(), begins.end(),
              [&](const NewContact& x, const NewContact& y) { return key(x) < key(y); });
    const bool has_listeners = has_pre_solve_listeners(world.listeners);
    std::vector<std::uint32_t> heavy;
    for (const NewContact& next : begins) {
        ASSERT(next.task < scratch.tasks.size());
        const NarrowPhaseTask& task = scratch.tasks[next.task];
        ASSERT(world.contacts.ids.alive(task.contact) && !task.persists);
        std::uint32_t contact = task.contact;
        ASSERT(task.list >= 0);
        const auto list = static_cast<std::size_t>(task.list);
        const Manifold* manifold = nullptr;
        if (next.child >= 0) {
            ASSERT(static_cast<std::size_t>(next.child) < scratch.children[list].size());
            const ChildManifold& child =
                scratch.children[list][static_cast<std::size_t>(next.child)].child;
            contact = create_child_contact(world, task.contact, child.key);
            manifold = &child.manifold;
        } else {
            manifold = &scratch.fresh[list];
        }
        const Contact& c = world.contacts.contacts[contact];
        ASSERT(!c.has_bound && !c.composite);
        if (world.bodies.cold[c.body_b].type == BodyType::dynamic) {
            note_heavy(world.bodies, c, heavy);
            match_sets(world, world.joints, world.bodies.cold[c.body_a].island,
                       world.bodies.cold[c.body_b].island);
        }
        ASSERT(manifold->count >= 1 && manifold->count <= 4);
        add_contact(world, contact, manifold->count == 1);
        write_manifold(world, world.contacts.contacts[contact], *manifold, true);
        if (has_listeners && modify_contact(world, contact))
            write_manifold(world, world.contacts.contacts[contact], *manifold, true);
    }
    begins.clear();
    raise_to_direct_tier(world, world.joints, heavy);
    return ran;
}

}  // namespace jostle::physics
