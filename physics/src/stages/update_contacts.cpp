// SPDX-License-Identifier: MIT
#include "stages/update_contacts.h"

#include <algorithm>

#include "collision/narrowphase/collide.h"
#include "constraints/write_manifold.h"
#include "geometry/ray.h"
#include "jostle/physics/tuning.h"
#include "state/lanes.h"
#include "state/links.h"

namespace jostle::physics {
namespace {

// ---- which pairs to look at ----

// Takes the due entries off the waiting list, and drops those whose bodies all fell asleep.
void take_due_pairs(WorldState& world, std::vector<ContactCheck>& checks) {
    std::vector<Waiting>& waiting = world.contacts.waiting;
    const std::vector<BodyReach>& reach = world.bodies.reach;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < waiting.size(); k++) {
        const Waiting w = waiting[k];
        Contact& c = world.contacts.contacts[w.contact];
        if (c.dormant) {
            c.waiting = false;
            c.limit = w.limit;
        } else if (reach[w.body_a].reach + reach[w.body_b].reach > w.limit) {
            c.waiting = false;
            checks.push_back({.contact = w.contact});
        } else {
            waiting[kept++] = w;
        }
    }
    waiting.resize(kept);
}

void take_aged_manifolds(const WorldState& world, std::vector<ContactCheck>& checks) {
    for (const Colour& colour : world.manifolds.colours)
        for (const BlockSide& side : colour.sides) {
            if (side.aged == 0) continue;
            for (int lane = 0; lane < 8; lane++)
                if ((side.aged >> lane & 1) != 0 && side.contact[lane] != none)
                    checks.push_back({.contact = side.contact[lane]});
        }
}

// ---- looking at one pair ----

struct Motion {
    Vec3 center, v, w;
};
Motion motion_of(const WorldState& world, std::uint32_t body) {
    const BodyWarm& warm = warm_of(world, body);
    return {warm.center, warm.v, warm.w};
}

// How far ahead to look for contacts: the way the pair closes in a step, but no more than the
// smaller body's size. Beyond that a manifold would see a plane where there is an edge to fly past,
// so the whole way counts only when a centre would run into the other shape: without it a fast ball
// is before a thin wall in one step and behind it in the next.
double closing_reach(const WorldState& world, const Contact& c, const Placed& shape_a,
                     const Placed& shape_b, double dt) {
    const BodyCold &a = world.bodies.cold[c.body_a], &b = world.bodies.cold[c.body_b];
    const Motion ma = motion_of(world, c.body_a), mb = motion_of(world, c.body_b);
    const Vec3 motion = (ma.v - mb.v) * dt;
    const double way = length(motion) + (length(ma.w) * a.radius + length(mb.w) * b.radius) * dt;
    const double size = b.type == BodyType::dynamic ? minimum(a.radius, b.radius) : a.radius;
    if (way <= size) return way;
    if (length(motion) <= size) return size;  // it is the turn that is fast
    const bool runs_into = cast_ray(shape_b, ma.center, motion).has_value() ||
                           cast_ray(shape_a, mb.center, -motion).has_value();
    return runs_into ? way : size;
}

// The smallest gap that any point may have at the end of the step, as the bodies move now.
double expected_gap(const WorldState& world, const Contact& c, const Manifold& m, double dt) {
    const Motion a = motion_of(world, c.body_a), b = motion_of(world, c.body_b);
    double smallest = 1e300;
    for (int i = 0; i < m.count; i++) {
        const Vec3 va = a.v + cross(a.w, m.point[i] - a.center);
        const Vec3 vb = b.v + cross(b.w, m.point[i] - b.center);
        const double closing = maximum(0, -dot(m.normal, vb - va));
        smallest = minimum(smallest, m.gap[i] - closing * dt);
    }
    return smallest;
}

void look(WorldState& world, ContactCheck& check, double dt) {
    Contact& c = world.contacts.contacts[check.contact];
    const ShapeRecord& sa = world.shapes.shapes[c.shape_a];
    const ShapeRecord& sb = world.shapes.shapes[c.shape_b];
    const Placed a = placed(sa, warm_of(world, c.body_a)), b = placed(sb, warm_of(world, c.body_b));
    const double margin = tuning::speculative_margin + closing_reach(world, c, a, b, dt);
    check.manifold = collide(a, b, margin, c.axis);
    check.gap_ahead = expected_gap(world, c, check.manifold, dt);
    check.expected = check.gap_ahead < tuning::speculative_margin;
    if (c.colour >= 0 && check.manifold.count > 0) write_manifold(world, c, check.manifold, false);
}

// ---- what came of it ----

bool has_sleeper(const WorldState& world, const Contact& c) {
    return world.bodies.cold[c.body_a].set == BodySet::sleeping ||
           world.bodies.cold[c.body_b].set == BodySet::sleeping;
}

// A plane has no box; b is the only one that can be a plane.
bool boxes_overlap(const WorldState& world, const Contact& c) {
    const ShapeRecord &a = world.shapes.shapes[c.shape_a], &b = world.shapes.shapes[c.shape_b];
    if (is_plane(b)) return reaches_plane(world, b, a.fat);
    return overlap(a.fat, b.fat);
}

double smallest_gap(const Manifold& m) {
    double gap = m.distance;
    for (int i = 0; i < m.count; i++) gap = i == 0 ? m.gap[0] : minimum(gap, m.gap[i]);
    return gap;
}

// No manifold (any more): the pair waits until its bodies may have come near, or ends when its
// boxes parted.
void wait_or_end(WorldState& world, const ContactCheck& check, double near) {
    Contact& c = world.contacts.contacts[check.contact];
    if (c.touching) {
        world.events.contacts_ended.push_back({shape_id(world, c.shape_a),
                                               shape_id(world, c.shape_b), body_id(world, c.body_a),
                                               body_id(world, c.body_b)});
        end_touch(world, check.contact);
    }
    if (c.colour >= 0) release_lane(world, check.contact);
    if (!boxes_overlap(world, c)) {
        destroy_contact(world, check.contact, world.events.contacts_ended);
        return;
    }
    const double travel = world.bodies.reach[c.body_a].travel + world.bodies.reach[c.body_b].travel;
    put_on_waiting_list(world, check.contact, travel + smallest_gap(check.manifold) - near);
}

void decide(WorldState& world, ContactCheck& check) {
    Contact& c = world.contacts.contacts[check.contact];
    StepScratch& scratch = world.scratch;
    if (has_sleeper(world, c)) {
        if (check.gap_ahead < tuning::wake_gap) {
            for (const std::uint32_t body : {c.body_a, c.body_b})
                if (world.bodies.cold[body].set == BodySet::sleeping)
                    scratch.to_wake.push_back(world.bodies.cold[body].island);
            scratch.new_lanes.push_back(static_cast<std::uint32_t>(&check - scratch.checks.data()));
        } else {
            wait_or_end(world, check, tuning::wake_gap);
        }
        return;
    }
    // A manifold that exists stays while it has points; a new one begins when they may meet in this
    // step.
    if (check.manifold.count > 0 && (c.colour >= 0 || check.expected)) {
        if (c.colour >= 0)
            finish_manifold(world, c);
        else
            scratch.new_lanes.push_back(static_cast<std::uint32_t>(&check - scratch.checks.data()));
        return;
    }
    wait_or_end(world, check, tuning::speculative_margin);
}

void wake_islands(WorldState& world) {
    auto& islands = world.scratch.to_wake;
    std::sort(islands.begin(), islands.end());
    islands.erase(std::unique(islands.begin(), islands.end()), islands.end());
    for (const std::uint32_t island : islands) wake_island(world, island, world.events.woke);
}

// In order of shapes, so that colours and lanes do not depend on the order of the waiting list.
void begin_manifolds(WorldState& world) {
    auto& fresh = world.scratch.new_lanes;
    const auto key = [&](std::uint32_t check) {
        const Contact& c = world.contacts.contacts[world.scratch.checks[check].contact];
        return std::pair(c.shape_a, c.shape_b);
    };
    std::sort(fresh.begin(), fresh.end(),
              [&](std::uint32_t x, std::uint32_t y) { return key(x) < key(y); });
    for (const std::uint32_t index : fresh) {
        const ContactCheck& check = world.scratch.checks[index];
        take_lane(world, check.contact);
        const Contact& c = world.contacts.contacts[check.contact];
        write_manifold(world, c, check.manifold, true);
        finish_manifold(world, c);
    }
}

}  // namespace

void update_contacts(StepContext& step) {
    WorldState& world = step.world;
    auto& checks = world.scratch.checks;
    checks.clear();
    world.scratch.new_lanes.clear();
    world.scratch.to_wake.clear();
    take_due_pairs(world, checks);
    take_aged_manifolds(world, checks);
    step.team.run(static_cast<int>(checks.size()), 32, [&](int begin, int end) {
        for (int k = begin; k < end; k++) look(world, checks[static_cast<std::size_t>(k)], step.dt);
    });
    for (ContactCheck& check : checks) decide(world, check);
    wake_islands(world);
    begin_manifolds(world);
    world.profile.pairs_checked = static_cast<int>(checks.size());
}

}  // namespace jostle::physics
