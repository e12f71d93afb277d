// SPDX-License-Identifier: MIT
#include "physics/src/state/island_sleep.h"

#include "physics/src/foundation/check.h"
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

// A kinematic body without velocity: as good as fixed.
bool is_parked(const WorldState& world, std::uint32_t body) {
    const BodyWarm& warm = warm_of(world, body);
    return !is_dynamic(world, body) && warm.v == Vec3{} && warm.w == Vec3{};
}

}  // namespace

namespace {

// Those of an island that a touch leaves as they lie: all but what a kinematic body leads.
std::vector<std::uint32_t> bodies_staying_asleep(WorldState& world,
                                                 const std::vector<BodyWarm>& sleepers) {
    std::vector<std::uint32_t> still;
    if (!world.def.sleeping || sleepers.size() < tuning::partial_sleep_least) return still;
    for_each_jointed(world, sleepers, [&](const JointedBodies& jointed) {
        if (!jointed.to_kinematic)
            still.insert(still.end(), jointed.bodies.begin(), jointed.bodies.end());
    });
    if (still.size() < tuning::partial_sleep_least) still.clear();
    return still;
}

// By how much strain makes an island's sub-steps longer.
double lengthening(const WorldState& world, const Island& island) {
    return static_cast<double>(substeps_of(island.colour_set, world.def)) /
           substeps_of(island.colour_set, world);
}

}  // namespace

void wake_island(WorldState& world, std::uint32_t island_index, std::vector<BodyId>& woke) {
    Island& island = world.islands.islands[island_index];
    if (!island.asleep) return;
    ASSERT(island.sleepers.size() == island.bodies);
    island.asleep = false;
    const std::vector<BodyWarm> sleepers = std::move(island.sleepers);
    const std::vector<SavedContact> manifolds = std::move(island.manifolds);
    island.sleepers = {};
    island.manifolds = {};
    for (const BodyWarm& warm : sleepers) enter_awake(world, warm);
    const std::vector<std::uint32_t> still = bodies_staying_asleep(world, sleepers);
    for (const std::uint32_t body : still) hold_still(world, body);
    for (const BodyWarm& warm : sleepers)
        if (!world.bodies.cold[warm.body].asleep_in_place)
            woke.push_back(body_id(world, warm.body));
    // Steps may have another length than when it fell asleep.
    const double scale = island.dt > 0 && world.last_dt > 0
                             ? world.last_dt * lengthening(world, island) / island.dt
                             : 1;
    island.dt = 0;
    if (scale != 1)
        for (const BodyWarm& warm : sleepers) scale_joints(world, warm.body, scale);
    for (const SavedContact& saved : manifolds) {
        restore_contact(world, saved);
        if (scale != 1)
            scale_impulses(lane_ref_of(world, world.contacts.contacts[saved.contact]),
                           static_cast<float>(scale), false);
        if (!still.empty()) save_load(world, saved.contact);
        world.contacts.contacts[saved.contact].dormant = false;
    }
    // What has no manifold keeps its bound. A contact with another island that still sleeps is
    // awake now on one side.
    for (const BodyWarm& warm : sleepers)
        for_each_contact(world.contacts, world.bodies.cold[warm.body], [&](std::uint32_t contact) {
            const Contact& c = world.contacts.contacts[contact];
            if (c.dormant) resume_separation_bound(world, contact);
        });
}

namespace {

// How many it has, so that a heap's memory is taken once.
std::size_t manifolds_of(const WorldState& world, std::uint32_t island) {
    std::size_t count = 0;
    for (std::uint32_t body = world.islands.islands[island].first; body != none;
         body = world.bodies.cold[body].island_next)
        for_each_manifold(world.contacts, world.bodies.cold[body], [&](std::uint32_t index) {
            const Contact& c = world.contacts.contacts[index];
            const bool first =
                c.body_a == body || world.bodies.cold[c.body_a].island != island;  // of two
            count += first ? 1 : 0;
        });
    return count;
}

}  // namespace

void put_island_to_sleep(WorldState& world, std::uint32_t island_index,
                         std::vector<ContactEnd>& ended) {
    Island& island = world.islands.islands[island_index];
    ASSERT(!island.asleep && island.sleepers.empty());
    island.sleepers.reserve(island.bodies);
    island.manifolds.reserve(manifolds_of(world, island_index));
    // Manifolds first, while the hot indices still mean something. Each contact is met at its body
    // a, or at b when only b is of this island.
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
                // A manifold with an awake outsider (near, not touching) or a kinematic one ends;
                // the pair gets a bound.
                const bool keep = inside || !other_moves;
                if (keep) island.manifolds.push_back(save_contact(world, contact));
                remove_contact(world, contact);
                if (!keep) {
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
                    clear_modifier(world, contact);
                    add_separation_bound(world, contact, -1);
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
        leave_set(world, body);
        cold.set = BodySet::sleeping;
        cold.at = static_cast<std::uint32_t>(island.sleepers.size());
        island.sleepers.push_back(warm);
        world.bodies.motion[body].bound = world.bodies.motion[body].travel;
    }
    ASSERT(island.sleepers.size() == island.bodies);
    island.asleep = true;
    island.dt = world.last_dt * lengthening(world, island);
}

}  // namespace jostle::physics
