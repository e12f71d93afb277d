// SPDX-License-Identifier: MIT
#include "physics/src/stages/sleep/put_parts_to_sleep.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/contact_load.h"
#include "physics/src/state/joint_graph.h"
#include "physics/src/state/partial_sleep.h"

namespace jostle::physics {
namespace {

// Calls visit(contact, hot index of a, of b) for every solved manifold of two dynamic bodies.
template <class Visit>
void for_each_bond(const ConstraintGraph& graph, Visit&& visit) {
    for_each_colour(graph.solved(), [&](const GraphColour& colour, int c) {
        if (pair_kind_of(c) != PairKind::dynamic) return;
        for (std::size_t k = 0; k < colour.metas.size(); k++)
            for (int lane = 0; lane < lanes_per_block(c); lane++) {
                if (colour.metas[k].contact[lane] == none) continue;
                ASSERT(colour.blocks[k].a[lane] > 0 && colour.blocks[k].b[lane] > 0);
                visit(colour.metas[k].contact[lane],
                      static_cast<std::size_t>(colour.blocks[k].a[lane]),
                      static_cast<std::size_t>(colour.blocks[k].b[lane]));
            }
    });
}

bool is_load_changed(const ContactGraph& stores, const Contact& c, std::uint32_t sleeper) {
    const BodyCold& cold = stores.bodies.cold[sleeper];
    const double weight = cold.mass * length(stores.def.gravity) * absolute(cold.gravity_scale);
    const Vec3 before = saved_load(c);
    const double most =
        tuning::wake_load_weight * weight + tuning::wake_load_share * length(before);
    return length_squared(load_of(stores, c) - before) > most * most;
}

double momentum_of(const BodyWarm& warm, const BodyCold& cold, double dt) {
    return cold.mass * (length(warm.v) + length(warm.w) * cold.radius) + length(warm.force) * dt;
}

// ---- bodies that fall asleep ----

bool is_restless(const BodyWarm& warm, const BodyCold& cold) {
    if (cold.asleep_in_place) return false;
    return cold.type != BodyType::dynamic || warm.sleep_time < tuning::partial_sleep_time;
}

// Jointed bodies fall asleep together or not at all: if one of them is marked, all are. This
// includes bodies jointed to a kinematic body. A kinematic body at rest may be in the awake set
// while its jointed bodies sleep; those have no marks.
void propagate_to_jointed(WorldState& world, std::vector<std::uint8_t>& marks) {
    if (world.joints.ids.alive_count() == 0) return;
    const auto is_awake = [&](std::uint32_t body) {
        return world.bodies.cold[body].set == BodySet::awake;
    };
    const auto mark = [&](std::uint32_t body) -> std::uint8_t& {
        ASSERT(is_awake(body) && world.bodies.cold[body].at + 1 < marks.size());
        return marks[world.bodies.cold[body].at + 1];
    };
    for_each_jointed(world.bodies, world.joints, world.scratch, world.bodies.awake,
                     [&](const JointedBodies& jointed) {
                         std::uint8_t any = jointed.to_kinematic ? 1 : 0;
                         for (const std::uint32_t body : jointed.bodies)
                             if (is_awake(body)) any |= mark(body);
                         for (const std::uint32_t body : jointed.bodies)
                             if (is_awake(body)) mark(body) = any;
                     });
}

// By hot index: bodies that do not rest, and bodies that touch them.
void find_restless(const BodyStore& bodies, const ConstraintGraph& graph, SleepScratch& scratch) {
    scratch.restless.assign(bodies.awake.size() + 1, 0);
    for (std::size_t i = 0; i < bodies.awake.size(); i++) {
        const BodyWarm& warm = bodies.awake[i];
        if (is_restless(warm, bodies.cold[warm.body])) scratch.restless[i + 1] = 1;
    }
    scratch.near_restless = scratch.restless;
    for_each_bond(graph, [&](std::uint32_t, std::size_t a, std::size_t b) {
        scratch.near_restless[a] |= scratch.restless[b];
        scratch.near_restless[b] |= scratch.restless[a];
    });
}

}  // namespace

void request_disturbed_wakes(StepContext& step) {
    WorldState& world = step.world;
    if (world.bodies.asleep_in_place == 0) return;
    WakeRequests& requests = world.wake_requests;
    // Bodies carried by a kinematic body have no rest time: see update_sleep.cpp.
    for (const BodyWarm& warm : world.bodies.awake)
        if (world.bodies.cold[warm.body].asleep_in_place && warm.sleep_time == 0)
            requests.push_back({warm.body});
    for_each_bond(world.graph, [&](std::uint32_t contact, std::size_t a, std::size_t b) {
        const Contact& c = world.contacts.contacts[contact];
        const BodyCold &cold_a = world.bodies.cold[c.body_a], &cold_b = world.bodies.cold[c.body_b];
        if (cold_a.asleep_in_place == cold_b.asleep_in_place) return;
        const std::uint32_t body = cold_a.asleep_in_place ? c.body_a : c.body_b;
        const BodyWarm& mover = world.bodies.awake[(cold_a.asleep_in_place ? b : a) - 1];
        const BodyCold& cold = cold_a.asleep_in_place ? cold_b : cold_a;
        ASSERT(mover.body == (cold_a.asleep_in_place ? c.body_b : c.body_a));
        if (c.touching && mover.sleep_time == 0)
            requests.push_back({body, mass_to_wake(momentum_of(mover, cold, step.dt))});
        else if (is_load_changed(world, c, body))
            requests.push_back({.body = body, .briefly = true});
    });
}

void put_parts_to_sleep(StepContext& step) {
    WorldState& world = step.world;
    if (world.steps % tuning::partial_sleep_interval != 0) return;
    SleepScratch& scratch = step.scratch.sleep;
    const bool any =
        std::any_of(scratch.islands.begin(), scratch.islands.end(), [&](std::uint32_t island) {
            return scratch.longest[island] >= tuning::partial_sleep_time;
        });
    if (!any) return;
    ASSERT(scratch.longest.size() == world.islands.ids.size());
    find_restless(world.bodies, world.graph, scratch);
    // By island: number of resting bodies whose neighbours rest, too.
    auto& count = scratch.resting;
    count.assign(world.islands.ids.size(), 0);
    const auto rests = [&](std::size_t i, const BodyCold& cold) {
        return scratch.near_restless[i + 1] == 0 &&
               (cold.constraints > 0 || cold.first_joint != none);
    };
    for (std::size_t i = 0; i < world.bodies.awake.size(); i++) {
        const BodyCold& cold = world.bodies.cold[world.bodies.awake[i].body];
        if (!rests(i, cold)) continue;
        ASSERT(cold.island < count.size());
        count[cold.island]++;
    }
    propagate_to_jointed(world, scratch.near_restless);
    // In a moving island a sleeping body would support loads that are about to shift. Islands that
    // are solved directly have no sleeping bodies, and cost little at rest.
    const auto calm = [&](std::uint32_t island) {
        return world.islands.islands[island].colour_set.tier != SolverTier::direct &&
               count[island] >= tuning::partial_sleep_least &&
               count[island] >= tuning::partial_sleep_share * world.islands.islands[island].bodies;
    };
    auto& falling_asleep = scratch.falling_asleep;
    falling_asleep.clear();
    for (std::size_t i = 0; i < world.bodies.awake.size(); i++) {
        const std::uint32_t body = world.bodies.awake[i].body;
        const BodyCold& cold = world.bodies.cold[body];
        if (rests(i, cold) && !cold.asleep_in_place && calm(cold.island))
            falling_asleep.push_back(body);
    }
    sleep_in_place(world, falling_asleep);
    for (const std::uint32_t body : falling_asleep)
        world.events.fell_asleep.push_back(body_id(world.bodies, body));
}

}  // namespace jostle::physics
