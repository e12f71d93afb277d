// SPDX-License-Identifier: MIT
#include "physics/src/stages/stages.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/constraint_graph/wide_rows.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/islands/island_stages.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/contact_graph.h"

namespace jostle::physics {
namespace {

// The warm records still contain the velocities before the solve: the approach of the impact.
ContactBegin begin_event(ContactGraph& stores, const Contact& c) {
    const ContactLaneRef lane_ref = lane_ref_of(stores.graph, c);
    const Vec3 normal = normal_of(lane_ref);
    const BodyWarm &a = warm_of(stores, c.body_a), &b = warm_of(stores, c.body_b);
    const Vec3 point = a.center + get_lane(lane_ref.block->arm_a, lane_ref.lane);
    const Vec3 va = a.v + cross(a.w, point - a.center), vb = b.v + cross(b.w, point - b.center);
    return {.shape_a = shape_id(stores.shapes, c.shape_a),
            .shape_b = shape_id(stores.shapes, c.shape_b),
            .body_a = body_id(stores.bodies, c.body_a),
            .body_b = body_id(stores.bodies, c.body_b),
            .point = point,
            .normal = normal,
            .approach_speed = maximum(0, -dot(normal, vb - va))};
}

void report_begin(WorldState& world, const Contact& c) {
    const ContactBegin begin = begin_event(world, c);
    world.events.contacts_began.push_back(begin);
    if (begin.approach_speed >= world.def.hit_speed)
        world.events.hits.push_back({begin.shape_a, begin.shape_b, begin.body_a, begin.body_b,
                                     begin.point, begin.normal, begin.approach_speed});
}

void toggle_touch(WorldState& world, std::uint32_t contact) {
    const Contact& c = world.contacts.contacts[contact];
    ASSERT(c.colour >= 0 && !c.composite);
    if (!c.touching) {
        if (c.parent == none)
            report_begin(world, c);
        else
            world.changed_pairs.push_back(c.parent);
        begin_touch(world, world.joints, contact);
    } else {
        if (c.parent == none) report_end(world, c, world.events.contacts_ended);
        end_touch(world, contact);
    }
}

// Records the body of a contact that has much more mass than the other.
void note_heavy(const BodyStore& bodies, const Contact& c, std::vector<std::uint32_t>& heavy) {
    const double a = bodies.cold[c.body_a].mass, b = bodies.cold[c.body_b].mass;
    if (maximum(a, b) >= tuning::heavy_ratio * minimum(a, b))
        heavy.push_back(a > b ? c.body_a : c.body_b);
}

// A composite pair begins with its first touching child and ends with its last.
void report_composites(WorldState& world) {
    auto& changed = world.changed_pairs;
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    for (const std::uint32_t pair : changed) {
        if (!world.contacts.ids.alive(pair)) continue;
        Contact& c = world.contacts.contacts[pair];
        if (!c.composite) continue;
        end_touch_of_pair(world, pair, world.events.contacts_ended);
        if (c.touching || c.touching_children == 0) continue;
        std::uint32_t first = c.first_child;
        while (!world.contacts.contacts[first].touching) {
            first = world.contacts.contacts[first].next_child;
            ASSERT(first != none);
        }
        report_begin(world, world.contacts.contacts[first]);
        c.touching = true;
    }
    changed.clear();
}

}  // namespace

Skipped merge_islands(StepContext& step) {
    if (step.world.bodies.awake.empty()) return no_awake_bodies;
    WorldState& world = step.world;
    std::vector<std::uint32_t>& changes = step.scratch.islands.touch_changes;
    changes.clear();
    int manifolds = 0, touching = 0;
    for_each_colour(world.graph.sets, [&](GraphColour& colour) {
        manifolds += colour.contacts;
        for (ContactConstraintWideMeta& meta : colour.metas) {
            touching += __builtin_popcount(meta.bits(LaneFlag::touching_now));
            const unsigned changed =
                meta.bits(LaneFlag::touching_now) ^ meta.bits(LaneFlag::touching);
            if (changed == 0) continue;
            for (int lane = 0; lane < 8; lane++)
                if ((changed >> lane & 1) != 0 && meta.contact[lane] != none)
                    changes.push_back(meta.contact[lane]);
            meta.bits(LaneFlag::touching) = meta.bits(LaneFlag::touching_now);
        }
    });
    // In order of contact index, because the order decides which island absorbs which.
    std::sort(changes.begin(), changes.end());
    ASSERT(std::adjacent_find(changes.begin(), changes.end()) == changes.end());
    std::vector<std::uint32_t> heavy;
    for (const std::uint32_t contact : changes) {
        toggle_touch(world, contact);
        const Contact& c = world.contacts.contacts[contact];
        if (c.touching && is_dynamic(world.bodies, c.body_b)) note_heavy(world.bodies, c, heavy);
    }
    ASSERT(touching <= manifolds);
    raise_to_heavy_tier(world, world.joints, heavy);
    leave_direct_tier(world, world.joints, step.scratch.solver.unsolved);
    report_composites(world);
    world.profile.manifolds = manifolds;
    world.profile.touching = touching;
    return ran;
}

}  // namespace jostle::physics
