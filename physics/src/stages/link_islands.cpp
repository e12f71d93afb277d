// SPDX-License-Identifier: MIT
#include "stages/link_islands.h"

#include <algorithm>

#include "state/lanes.h"
#include "state/links.h"

namespace jostle::physics {
namespace {

Vec3 row3(const float (*rows)[8], int lane) {
    return {double{rows[0][lane]}, double{rows[1][lane]}, double{rows[2][lane]}};
}

// The warm records still hold the velocities from before the solve: the approach of the impact.
ContactBegin begin_event(WorldState& world, const Contact& c) {
    const LanePlace place = place_of(world, c);
    const Vec3 normal = row3(place.block->normal, place.lane);
    const BodyWarm &a = warm_of(world, c.body_a), &b = warm_of(world, c.body_b);
    const Vec3 point = a.center + row3(place.block->arm_a, place.lane);
    const Vec3 va = a.v + cross(a.w, point - a.center), vb = b.v + cross(b.w, point - b.center);
    return {.shape_a = shape_id(world, c.shape_a),
            .shape_b = shape_id(world, c.shape_b),
            .body_a = body_id(world, c.body_a),
            .body_b = body_id(world, c.body_b),
            .point = point,
            .normal = normal,
            .approach = maximum(0, -dot(normal, vb - va))};
}

void change_touch(WorldState& world, std::uint32_t contact) {
    const Contact& c = world.contacts.contacts[contact];
    if (!c.touching) {
        world.events.contacts_began.push_back(begin_event(world, c));
        begin_touch(world, contact);
    } else {
        world.events.contacts_ended.push_back({shape_id(world, c.shape_a),
                                               shape_id(world, c.shape_b), body_id(world, c.body_a),
                                               body_id(world, c.body_b)});
        end_touch(world, contact);
    }
}

}  // namespace

void link_islands(StepContext& step) {
    WorldState& world = step.world;
    auto& changes = world.scratch.touch_changes;
    changes.clear();
    int manifolds = 0, touching = 0;
    for (Colour& colour : world.manifolds.colours) {
        manifolds += colour.lanes;
        for (BlockSide& side : colour.sides) {
            touching += __builtin_popcount(side.pressing);
            const unsigned changed = side.pressing ^ side.touching;
            if (changed == 0) continue;
            for (int lane = 0; lane < 8; lane++)
                if ((changed >> lane & 1) != 0 && side.contact[lane] != none)
                    changes.push_back(side.contact[lane]);
            side.touching = side.pressing;
        }
    }
    // By index of contact: the order decides which island takes in which.
    std::sort(changes.begin(), changes.end());
    for (const std::uint32_t contact : changes) change_touch(world, contact);
    world.profile.manifolds = manifolds;
    world.profile.touching = touching;
}

}  // namespace jostle::physics
