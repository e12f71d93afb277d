// SPDX-License-Identifier: MIT
#include "physics/src/stages/stages.h"

#include "jostle/base/check.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/sleep/put_parts_to_sleep.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/island_sleep.h"
#include "physics/src/state/islands.h"
#include "physics/src/state/partial_sleep.h"

namespace jostle::physics {
namespace {

// Keeps bodies jointed to a moving kinematic body awake.
void hold_towed_awake(BodySets& sets, const JointStore& joints,
                      const std::vector<std::uint32_t>& jointed) {
    for (const std::uint32_t hot : jointed) {
        ASSERT(hot > 0 && hot <= sets.bodies.awake.size());
        BodyWarm& warm = sets.bodies.awake[hot - 1];
        for_each_joint(joints, sets.bodies.cold[warm.body], [&](std::uint32_t joint) {
            const Joint& j = joints.joints[joint];
            const std::uint32_t other = j.body_a == warm.body ? j.body_b : j.body_a;
            if (other == none || sets.bodies.cold[other].type != BodyType::kinematic) return;
            const BodyWarm& driver = warm_of(sets, other);
            if (driver.v != Vec3{} || driver.w != Vec3{}) warm.sleep_time = 0;
        });
    }
}

// A body that touches a moving kinematic body is not at rest, however slow the motion.
void hold_carried_awake(ContactGraph& stores) {
    for_each_colour(stores.graph.sets, [&](const GraphColour& colour, int c) {
        if (pair_kind_of(c) != PairKind::kinematic) return;
        for (const ContactConstraintWideMeta& meta : colour.metas)
            for (int lane = 0; lane < 8; lane++) {
                if (!meta.has(LaneFlag::touching, lane)) continue;
                ASSERT(meta.contact[lane] != no_contact);
                const Contact& contact = stores.contacts.contacts[meta.contact[lane]];
                const BodyWarm& driver = warm_of(stores, contact.body_b);
                if (driver.v != Vec3{} || driver.w != Vec3{})
                    warm_of(stores, contact.body_a).sleep_time = 0;
            }
    });
}

// The shortest and longest rest time of the bodies of each awake island.
void measure_rest(const BodyStore& bodies, const IslandStore& islands, SleepScratch& scratch) {
    scratch.shortest.resize(islands.ids.size());
    scratch.longest.resize(islands.ids.size());
    for (const std::uint32_t i : scratch.islands) {
        scratch.shortest[i] = 1e300;
        scratch.longest[i] = 0;
    }
    for (const BodyWarm& warm : bodies.awake) {
        const std::uint32_t island = bodies.cold[warm.body].island;
        if (island == none) continue;  // kinematic
        scratch.shortest[island] = minimum(scratch.shortest[island], warm.sleep_time);
        scratch.longest[island] = maximum(scratch.longest[island], warm.sleep_time);
    }
}

// Bodies that slept in place have already been reported.
void fall_asleep(WorldState& world, std::uint32_t island) {
    ASSERT(!world.islands.islands[island].may_be_split);
    for (std::uint32_t body = world.islands.islands[island].first; body != none;
         body = world.bodies.cold[body].island_next) {
        if (!world.bodies.cold[body].asleep_in_place)
            world.events.fell_asleep.push_back(body_id(world.bodies, body));
        wake_in_place(world, body);
    }
    put_island_to_sleep(world, island, world.events.contacts_ended);
}

}  // namespace

Skipped update_sleep(StepContext& step) {
    WorldState& world = step.world;
    if (!world.def.sleeping) return "sleeping is disabled";
    if (world.bodies.awake.empty()) return no_awake_bodies;
    SleepScratch& scratch = step.scratch.sleep;
    hold_carried_awake(world);
    hold_towed_awake(world, world.joints, step.scratch.solver.jointed.all);
    find_awake_islands(world, scratch.islands);
    measure_rest(world.bodies, world.islands, scratch);
    // Splitting adds islands, which are measured in the next step.
    std::vector<std::uint32_t>& to_split = scratch.to_split;
    to_split.clear();
    std::uint32_t sleepiest = none;
    int awake = 0;
    for (const std::uint32_t i : scratch.islands) {
        awake++;
        if (scratch.longest[i] < tuning::time_to_sleep) continue;
        const bool all_rest = scratch.shortest[i] >= tuning::time_to_sleep;
        if (all_rest && !world.islands.islands[i].may_be_split) {
            fall_asleep(world, i);
            awake--;
        } else if (world.islands.islands[i].may_be_split &&
                   world.steps >= world.islands.islands[i].split_at + tuning::split_interval) {
            if (all_rest)
                to_split.push_back(i);
            else if (sleepiest == none || scratch.longest[sleepiest] < scratch.longest[i])
                sleepiest = i;
        }
    }
    // All islands that rest are split, because they fall asleep in the next step. Of islands that
    // partly move, one per step is enough: splitting a moving pile would be wasted.
    if (to_split.empty() && sleepiest != none) to_split.push_back(sleepiest);
    for (const std::uint32_t island : to_split) split_island(world, island);
    if (to_split.empty()) put_parts_to_sleep(step);
    world.profile.islands_awake = awake;
    return ran;
}

}  // namespace jostle::physics
