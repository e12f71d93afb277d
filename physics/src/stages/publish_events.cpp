// SPDX-License-Identifier: MIT
#include "physics/src/stages/stages.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/constraint_graph/wide_rows.h"

namespace jostle::physics {
namespace {

template <class Event>
void sort_by_shapes(std::vector<Event>& events) {
    std::stable_sort(events.begin(), events.end(), [](const Event& x, const Event& y) {
        return std::pair(x.shape_a, x.shape_b) < std::pair(y.shape_a, y.shape_b);
    });
}

template <class Event>
void sort_by_trigger(std::vector<Event>& events) {
    std::sort(events.begin(), events.end(), [](const Event& x, const Event& y) {
        return std::pair(x.trigger, x.shape) < std::pair(y.trigger, y.shape);
    });
}

// The event of one touching manifold. Impulses are those of the last sub-step times the number of
// sub-steps.
ContactStay stay_of(const ContactGraph& stores, const Contact& c,
                    const ContactConstraintWide& block, int lane) {
    ASSERT(c.touching);
    const double substeps = substeps_of(c.colour_set, stores);
    double normal = 0, deepest = 1e300;
    for (int k = 0; k < 4; k++) {
        normal += double{block.lambda[k][lane]};
        deepest = minimum(deepest, double{block.gap[k][lane]});
    }
    const double f1 = double{block.friction[0][lane]}, f2 = double{block.friction[1][lane]};
    return {.shape_a = shape_id(stores.shapes, c.shape_a),
            .shape_b = shape_id(stores.shapes, c.shape_b),
            .body_a = body_id(stores.bodies, c.body_a),
            .body_b = body_id(stores.bodies, c.body_b),
            .point = warm_of(stores, c.body_a).center + get_lane(block.arm_a, lane),
            .normal = get_lane(block.normal, lane),
            .normal_impulse = normal * substeps,
            .friction_impulse = square_root(f1 * f1 + f2 * f2) * substeps,
            .penetration = -deepest};
}

void report_stays(WorldState& world) {
    auto& stays = world.events.contacts;
    for_each_colour(world.graph.solved(), [&](const GraphColour& colour) {
        for (std::size_t k = 0; k < colour.blocks.size(); k++) {
            const ContactConstraintWideMeta& meta = colour.metas[k];
            const unsigned reported = meta.bits(LaneFlag::touching) & meta.bits(LaneFlag::reports);
            if (reported == 0) continue;
            for (int lane = 0; lane < 8; lane++) {
                if ((reported >> lane & 1) == 0) continue;
                ASSERT(meta.contact[lane] != no_contact);
                stays.push_back(stay_of(world, world.contacts.contacts[meta.contact[lane]],
                                        colour.blocks[k], lane));
            }
        }
    });
    sort_by_shapes(stays);
    // The manifolds of a pair are reported as one contact, with the point and normal of the
    // hardest.
    std::size_t retained = 0;
    for (std::size_t k = 0; k < stays.size(); k++) {
        const bool same = retained > 0 && stays[retained - 1].shape_a == stays[k].shape_a &&
                          stays[retained - 1].shape_b == stays[k].shape_b;
        if (!same) {
            stays[retained++] = stays[k];
            continue;
        }
        ContactStay& sum = stays[retained - 1];
        if (stays[k].normal_impulse > sum.normal_impulse) {
            sum.point = stays[k].point;
            sum.normal = stays[k].normal;
        }
        sum.normal_impulse += stays[k].normal_impulse;
        sum.friction_impulse += stays[k].friction_impulse;
        sum.penetration = maximum(sum.penetration, stays[k].penetration);
    }
    stays.resize(retained);
}

}  // namespace

Skipped publish_events(StepContext& step) {
    EventStore& events = step.world.events;
    if (events.empty() && step.world.shapes.reporters == 0) return "no events";
    sort_by_shapes(events.contacts_began);
    sort_by_shapes(events.contacts_ended);
    sort_by_shapes(events.hits);
    if (step.world.shapes.reporters > 0) report_stays(step.world);
    sort_by_trigger(events.triggers_entered);
    sort_by_trigger(events.triggers_stayed);
    sort_by_trigger(events.triggers_left);
    std::sort(events.joints_broke.begin(), events.joints_broke.end(),
              [](const JointBreak& x, const JointBreak& y) { return x.joint < y.joint; });
    std::sort(events.fell_asleep.begin(), events.fell_asleep.end());
    std::sort(events.woke.begin(), events.woke.end());
    std::sort(events.quarantined.begin(), events.quarantined.end());
    return ran;
}

}  // namespace jostle::physics
