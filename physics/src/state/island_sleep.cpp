// SPDX-License-Identifier: MIT
#include "physics/src/state/island_sleep.h"

#include "jostle/base/check.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/state/body_sets.h"
#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/contact_graph.h"
#include "physics/src/state/contact_load.h"
#include "physics/src/state/contact_modifiers.h"
#include "physics/src/state/impulse_scale.h"
#include "physics/src/state/joint_graph.h"
#include "physics/src/state/partial_sleep.h"
#include "physics/src/state/separation_bounds.h"

namespace jostle::physics {
namespace {

// A kinematic body without velocity, which acts like a static one.
bool is_parked(const BodySets& sets, std::uint32_t body) {
    const BodyWarm& warm = warm_of(sets, body);
    return !is_dynamic(sets.bodies, body) && warm.v == Vec3{} && warm.w == Vec3{};
}

}  // namespace

namespace {

// Bodies that remain asleep in place when the island wakes: all except those connected to a
// kinematic body.
std::vector<std::uint32_t> bodies_staying_asleep(WorldState& world,
                                                 const std::vector<BodyWarm>& sleepers) {
    std::vector<std::uint32_t> still;
    if (!world.def.sleeping || sleepers.size() < tuning::partial_sleep_least) return still;
    for_each_jointed(
        world.bodies, world.joints, world.scratch, sleepers, [&](const JointedBodies& jointed) {
            if (!jointed.to_kinematic)
                still.insert(still.end(), jointed.bodies.begin(), jointed.bodies.end());
        });
    if (still.size() < tuning::partial_sleep_least) still.clear();
    return still;
}

// Factor by which the overload level makes the island's sub-steps longer.
double lengthening(const SteppingState& stepping, const Island& island) {
    ASSERT(island.colour_set != asleep_set);
    return static_cast<double>(
               substeps_of(island.colour_set, stepping.def, false, stepping.size_levels)) /
           substeps_of(island.colour_set, stepping);
}

}  // namespace

void wake_island(WorldState& world, std::uint32_t island_index, std::vector<BodyId>& woke) {
    Island& island = world.islands.islands[island_index];
    if (!island.asleep) return;
    ASSERT(island.sleepers.size() == island.bodies);
    island.asleep = false;
    const std::vector<BodyWarm> sleepers = std::move(island.sleepers);
    const std::vector<SavedContact> manifolds = std::move(island.manifolds);
    ASSERT(island.dt >= 0 && island.bodies > 0);
    island.sleepers = {};
    island.manifolds = {};
    for (const BodyWarm& warm : sleepers) enter_awake(world.bodies, warm);
    const std::vector<std::uint32_t> still = bodies_staying_asleep(world, sleepers);
    for (const std::uint32_t body : still) hold_still(world.bodies, body);
    for (const BodyWarm& warm : sleepers)
        if (!world.bodies.cold[warm.body].asleep_in_place)
            woke.push_back(body_id(world.bodies, warm.body));
    // The step length may differ from that at the time it fell asleep.
    const double longer = lengthening(world, island), dt = world.last_dt * longer;
    const double scale = island.dt > 0 && world.last_dt > 0 ? dt / island.dt : 1;
    ASSERT(scale > 0);
    const StepLengthChange change =
        scale == 1 ? StepLengthChange{}
                   : resting_step_length_change(island.dt, dt,
                                                stiffness_dt_of(world, world.last_dt) * longer);
    island.dt = 0;
    if (scale != 1)
        for (const BodyWarm& warm : sleepers)
            scale_joints(world.bodies, world.joints, warm.body, scale);
    for (const SavedContact& saved : manifolds) {
        restore_contact(world, saved);
        if (scale != 1)
            change_step_length(lane_ref_of(world.graph, world.contacts.contacts[saved.contact]),
                               change);
        if (!still.empty()) save_load(world, saved.contact);
        world.contacts.contacts[saved.contact].dormant = false;
    }
    // Contacts without a manifold retain their bound. A contact with another island that still
    // sleeps is now awake on one side.
    for (const BodyWarm& warm : sleepers)
        for_each_contact(world.contacts, world.bodies.cold[warm.body], [&](std::uint32_t contact) {
            const Contact& c = world.contacts.contacts[contact];
            if (c.dormant) resume_separation_bound(world.contacts, contact);
        });
}

namespace {

// Number of manifolds of an island, to allocate memory once.
std::size_t manifolds_of(const BodySets& sets, const ContactStore& contacts, std::uint32_t island) {
    std::size_t count = 0;
    for (std::uint32_t body = sets.islands.islands[island].first; body != none;
         body = sets.bodies.cold[body].island_next)
        for_each_manifold(contacts, sets.bodies.cold[body], [&](std::uint32_t index) {
            const Contact& c = contacts.contacts[index];
            const bool first =
                // Each contact once.
                c.body_a == body || sets.bodies.cold[c.body_a].island != island;
            count += first ? 1 : 0;
        });
    return count;
}

}  // namespace

void put_island_to_sleep(WorldState& world, std::uint32_t island_index,
                         std::vector<ContactEnd>& ended) {
    Island& island = world.islands.islands[island_index];
    ASSERT(!island.asleep && island.sleepers.empty());
    ASSERT(island.manifolds.empty() && island.bodies > 0);
    island.sleepers.reserve(island.bodies);
    island.manifolds.reserve(manifolds_of(world, world.contacts, island_index));
    // Save manifolds first, while the hot indices are valid. Each contact is visited at its body a,
    // or at b if only b is in this island.
    for (std::uint32_t body = island.first; body != none;
         body = world.bodies.cold[body].island_next) {
        for_each_contact(world.contacts, world.bodies.cold[body], [&](std::uint32_t contact) {
            Contact& c = world.contacts.contacts[contact];
            if (c.dormant) return;
            const std::uint32_t other = c.body_a == body ? c.body_b : c.body_a;
            const BodyCold& other_cold = world.bodies.cold[other];
            const bool inside = other_cold.island == island_index;
            const bool other_moves =
                other_cold.set == BodySet::awake && !inside && !is_parked(world, other);
            if (c.colour >= 0) {
                // A manifold with an awake body outside the island (close, not touching) or a
                // moving kinematic one ends; the pair gets a separation bound.
                const bool store_manifold = inside || !other_moves;
                if (store_manifold) island.manifolds.push_back(save_contact(world, contact));
                remove_contact(world, contact);
                if (!store_manifold) {
                    if (c.parent != none) {
                        const std::uint32_t parent = c.parent;
                        destroy_contact(world, contact, ended);
                        end_touch_of_pair(world, parent, ended);
                        return;
                    }
                    if (c.touching) {
                        report_end(world, c, ended);
                        end_touch(world, contact);
                    }
                    clear_modifier(world.contacts, contact);
                    add_separation_bound(world, world.contacts, contact, -1);
                    return;
                }
            }
            if (!other_moves) c.dormant = world.contacts.some_dormant = true;
        });
    }
    for (std::uint32_t body = island.first; body != none;
         body = world.bodies.cold[body].island_next) {
        BodyCold& cold = world.bodies.cold[body];
        BodyWarm warm = world.bodies.awake[cold.at];
        warm.v = warm.w = {};
        ASSERT(!cold.asleep_in_place && cold.constraints == 0);
        ASSERT(cold.colours == 0 && warm.body == body);
        leave_set(world, body);
        cold.set = BodySet::sleeping;
        cold.at = static_cast<std::uint32_t>(island.sleepers.size());
        island.sleepers.push_back(warm);
        world.bodies.motion[body].bound = world.bodies.motion[body].travel;
    }
    ASSERT(island.sleepers.size() == island.bodies);
    island.asleep = true;
    island.dt = world.last_dt * lengthening(world, island);
    ASSERT(island.dt >= 0);
}

}  // namespace jostle::physics
