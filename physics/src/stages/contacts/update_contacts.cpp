// SPDX-License-Identifier: MIT
#include "stages/contacts/update_contacts.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <tuple>

#include "collision/narrowphase/collide.h"
#include "collision/narrowphase/collide_planar.h"
#include "constraints/write_manifold.h"
#include "foundation/prefetch.h"
#include "jostle/physics/tuning.h"
#include "stages/contacts/pair_ahead.h"
#include "stages/contacts/separation_bound.h"
#include "stages/continuous/ccd_policy.h"
#include "state/contact_constraints.h"
#include "state/contact_graph.h"
#include "state/island_sleep.h"
#include "state/island_tiers.h"
#include "state/partial_sleep.h"
#include "state/separation_bounds.h"
#include "state/shape_proxy.h"

namespace jostle::physics {
namespace {

// ---- which pairs to look at ----

void queue(WorldState& world, std::uint32_t contact) {
    Contact& c = world.contacts.contacts[contact];
    if (c.queued) return;
    c.queued = true;
    world.scratch.checks.push_back(
        {.contact = contact, .list = c.composite ? world.scratch.part_lists++ : -1});
}

void note_held(WorldState& world) {
    auto& held = world.scratch.held;
    held.clear();
    for (const BodyWarm& warm : world.bodies.awake)
        held.push_back(world.bodies.cold[warm.body].constraints > 0 ? 1 : 0);
}

// Pairs whose bodies all fell asleep wait no longer.
void drop_dormant_pairs(WorldState& world) {
    if (!world.contacts.some_dormant) return;
    world.contacts.some_dormant = false;
    std::erase_if(world.contacts.bounds, [&](const SeparationBound& w) {
        Contact& c = world.contacts.contacts[w.contact];
        if (!c.dormant) return false;
        c.has_bound = false;
        c.limit = w.limit;
        return true;
    });
}

// Takes the due entries off the waiting list.
void take_due_pairs(StepContext& step) {
    WorldState& world = step.world;
    FlatArray<SeparationBound>& bounds = world.contacts.bounds;
    std::vector<std::uint8_t>& due = world.scratch.due;
    due.resize(bounds.size());
    step.team.run(static_cast<int>(bounds.size()), 512, [&](int begin, int end) {
        for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); k++)
            due[k] = is_due(world, bounds[k], step.dt) ? 1 : 0;
    });
    std::size_t kept = 0;
    for (std::size_t k = 0; k < bounds.size(); k++) {
        if (k + 8 < bounds.size() && due[k + 8] != 0)
            prefetch(world.contacts.contacts[bounds[k + 8].contact]);
        if (due[k] == 0) {
            bounds[kept++] = bounds[k];
            continue;
        }
        world.contacts.contacts[bounds[k].contact].has_bound = false;
        queue(world, bounds[k].contact);
    }
    bounds.resize(kept);
}

// A composite pair is looked at as a whole when any of its parts has aged.
void take_manifolds_to_rebuild(WorldState& world) {
    const auto prefetch_contacts_of = [&](const ContactConstraintWideMeta& meta) {
        for (int lane = 0; lane < 8; lane++)
            if ((meta.bits(LaneFlag::needs_rebuild) >> lane & 1) != 0 && meta.contact[lane] != none)
                prefetch(world.contacts.contacts[meta.contact[lane]]);
    };
    for_each_colour(world.graph.sets, [&](const GraphColour& colour) {
        for (std::size_t k = 0; k < colour.metas.size(); k++) {
            if (k + 3 < colour.metas.size()) prefetch_contacts_of(colour.metas[k + 3]);
            const ContactConstraintWideMeta& meta = colour.metas[k];
            if (meta.bits(LaneFlag::needs_rebuild) == 0) continue;
            for (int lane = 0; lane < 8; lane++) {
                if ((meta.bits(LaneFlag::needs_rebuild) >> lane & 1) == 0 ||
                    meta.contact[lane] == none)
                    continue;
                const Contact& c = world.contacts.contacts[meta.contact[lane]];
                queue(world, c.parent == none ? meta.contact[lane] : c.parent);
            }
        }
    });
}

// UninitializedArray for what threads will find.
void make_space(StepScratch& scratch) {
    const auto lists = static_cast<std::size_t>(scratch.part_lists);
    if (scratch.parts.size() < lists) scratch.parts.resize(lists);
    scratch.fresh.reserve_discarding(scratch.checks.size());
    scratch.fresh_count = 0;
}

// ---- looking at one pair ----

struct Motion {
    Vec3 center, v, w;
};
Motion motion_of(const WorldState& world, std::uint32_t body) {
    const BodyWarm& warm = warm_of(world, body);
    return {warm.center, warm.v, warm.w};
}

// How far two bodies move against each other in a step, at most.
double closing_way(const WorldState& world, const Contact& c, double dt) {
    const BodyCold &a = world.bodies.cold[c.body_a], &b = world.bodies.cold[c.body_b];
    const Motion ma = motion_of(world, c.body_a), mb = motion_of(world, c.body_b);
    const double turning_b = b.type == BodyType::fixed ? 0 : length(mb.w) * b.radius;
    return (length(ma.v - mb.v) + length(ma.w) * a.radius + turning_b) * dt;
}

// Whether the pair will be swept (stages/continuous/solve_continuous.h). That takes a body that is
// fast, and fast against the other.
bool will_be_swept(const WorldState& world, const Contact& c, double way, double dt) {
    if (!world.def.continuous) return false;
    const BodyCold &a = world.bodies.cold[c.body_a], &b = world.bodies.cold[c.body_b];
    const auto sweeps = [&](const BodyCold& mover, const BodyCold& other) {
        if (!mover.continuous || mover.set != BodySet::awake) return false;
        if (way <= motion_without_sweep(world, mover, other)) return false;
        const BodyWarm& warm = world.bodies.awake[mover.at];
        return (length(warm.v) + length(warm.w) * mover.radius) * dt >
               tuning::sweep_fraction * mover.inner_radius;
    };
    return sweeps(a, b) || sweeps(b, a);
}

// How fast two bodies come nearer to each other along a direction from a to b, m/s: their centres.
double closing_along(const WorldState& world, const Contact& c, Vec3 direction) {
    return dot(direction, motion_of(world, c.body_a).v - motion_of(world, c.body_b).v);
}
// ... and how much faster any two of their points may.
double closing_by_turning(const WorldState& world, const Contact& c) {
    const BodyCold &a = world.bodies.cold[c.body_a], &b = world.bodies.cold[c.body_b];
    const Vec3 wa = motion_of(world, c.body_a).w, wb = motion_of(world, c.body_b).w;
    return length(wa) * a.radius + (b.type == BodyType::fixed ? 0 : length(wb) * b.radius);
}

// How far ahead to look for contacts: the speculative margin and the way the pair closes in a step,
// but no more than the smaller body's size: beyond that a manifold would see a plane where there is
// an edge to fly past.
double closing_reach(const WorldState& world, const Contact& c, double way) {
    const BodyCold &a = world.bodies.cold[c.body_a], &b = world.bodies.cold[c.body_b];
    const double size = b.type == BodyType::dynamic ? minimum(a.radius, b.radius) : a.radius;
    return minimum(way, size);
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

// A composite pair is looked at a little further than it needs, so that it need not be looked at
// in every step.
constexpr double composite_slack = 0.01;  // m

// Finds for each part that exists the manifold that continues it: the same child, and of pieces of
// a surface the one with the nearest normal.
void match_parts(WorldState& world, const Contact& pair, std::vector<FoundPart>& found) {
    for (std::uint32_t p = pair.first_part; p != none; p = world.contacts.contacts[p].next_part) {
        const Contact& part = world.contacts.contacts[p];
        if (part.colour < 0) continue;
        const Vec3 normal = normal_of(place_of(world, part));
        FoundPart* best = nullptr;
        double most = 0.9;
        for (FoundPart& f : found) {
            if (f.contact != none || f.part.key != part.key) continue;
            const double like = dot(f.part.manifold.normal, normal);
            if (like > most) {
                most = like;
                best = &f;
            }
        }
        if (best == nullptr) continue;
        best->contact = p;
        write_manifold(world, part, best->part.manifold, false);
    }
}

void look_at_composite(WorldState& world, ContactCheck& check, double dt) {
    const Contact& c = world.contacts.contacts[check.contact];
    const double way = closing_way(world, c, dt);
    check.near = closing_reach(world, c, way) + composite_slack;
    const bool swept = will_be_swept(world, c, way, dt);
    std::optional<double> meeting;
    if (swept && uses_speculative_contact(world, c.shape_a, c.shape_b))
        meeting = time_to_meeting(world, c, dt);
    const double time = meeting && *meeting > 0 ? *meeting : time_to_middle(world, c, way, dt);
    const double way_ahead = way * time / dt;
    std::vector<PartManifold> parts;
    const PairAhead pair(world, c, time);
    collide_composite(pair.shape_a(), pair.shape_b(), tuning::speculative_margin + check.near,
                      parts);
    for (PartManifold& part : parts) pair.count_back(part.manifold, way_ahead);
    check.near -= way_ahead;
    std::vector<FoundPart>& found = world.scratch.parts[static_cast<std::size_t>(check.list)];
    found.clear();
    check.gap_ahead = 1e300;
    for (const PartManifold& part : parts) {
        if (swept && !meeting && part.manifold.distance > tuning::touch_gap) continue;
        found.push_back({part, expected_gap(world, c, part.manifold, dt), none});
        check.gap_ahead = minimum(check.gap_ahead, found.back().gap_ahead);
    }
    match_parts(world, c, found);
}

// Contacts, their bodies and shapes lie anywhere: asked for in the order in which one leads to the
// next, some checks before they are needed.
void prefetch_ahead(const WorldState& world, int k, int end) {
    const auto contact_of = [&](int check) -> const Contact& {
        return world.contacts
            .contacts[world.scratch.checks[static_cast<std::size_t>(check)].contact];
    };
    if (k + 12 < end) prefetch(contact_of(k + 12));
    if (k + 8 < end) {
        const Contact& c = contact_of(k + 8);
        for (const std::uint32_t body : {c.body_a, c.body_b})
            prefetch(world.bodies.cold[body], offsetof(BodyCold, local_center));
        for (const std::uint32_t shape : {c.shape_a, c.shape_b})
            prefetch(world.shapes.shapes[shape]);
    }
    if (k + 4 < end) {
        const Contact& c = contact_of(k + 4);
        for (const std::uint32_t body : {c.body_a, c.body_b}) prefetch(warm_of(world, body));
    }
}

// How two that do not touch are nearest.
struct Approach {
    Vec3 normal;
    double gap = 0;  // m
};
// By the manifold that they have.
Approach approach_of(WorldState& world, const Contact& c) {
    const ContactPlace place = place_of(world, c);
    double gap = no_point;
    for (const auto& row : place.block->gap) gap = minimum(gap, double{row[place.lane]});
    return {normal_of(place), gap};
}

// m. What two will touch with is plain once they are this far in each other. A crate slides towards
// a tile that lies flush with the one under it: before they meet the side of the tile is what parts
// them most, and would stop it; past that it is the top. More than contacts overlap at rest.
constexpr double just_past = 1e-3;

// The points where a pair may touch in this step.
Manifold manifold_ahead(WorldState& world, Contact& c, double dt) {
    const double way = closing_way(world, c, dt);
    const auto within = [&](double margin, const PairAhead& pair) {
        const Placed &a = pair.shape_a(), &b = pair.shape_b();
        Manifold m = world.def.planar ? collide_planar(a, b, margin, c.cache)
                                      : collide(a, b, margin, c.cache);
        pair.count_back(m, way * pair.time() / dt);
        return m;
    };
    const PairAhead pair(world, c, time_to_middle(world, c, way, dt));
    const bool swept = will_be_swept(world, c, way, dt);
    if (swept && !uses_speculative_contact(world, c.shape_a, c.shape_b))
        return within(tuning::touch_gap, pair);
    Approach near;
    if (c.colour < 0 || swept) {
        // Most of what moves much against each other flies past: that is cheaper to see than
        // points.
        const Manifold now = within(tuning::speculative_margin, pair);
        near = {now.normal, smallest_gap(now)};
        const double most = closing_along(world, c, near.normal) + closing_by_turning(world, c);
        if (now.count == 0 && near.normal != Vec3{} &&
            near.gap - most * dt >= tuning::speculative_margin)
            return now;
        const std::optional<double> meeting =
            swept ? time_to_meeting(world, c, dt) : std::optional(0.0);
        if (!meeting) return now;
        if (*meeting > 0)
            return within(tuning::speculative_margin,
                          PairAhead(world, c, minimum(dt, *meeting + just_past / most)));
    } else if (!c.touching) {
        near = approach_of(world, c);
    }
    const double margin = tuning::speculative_margin + closing_reach(world, c, way);
    const double closing = closing_along(world, c, near.normal);
    if (!c.touching && near.gap > 0 && near.gap < closing * dt)
        return within(margin, PairAhead(world, c, minimum(dt, (near.gap + just_past) / closing)));
    return within(margin, pair);
}

void look(WorldState& world, ContactCheck& check, double dt) {
    Contact& c = world.contacts.contacts[check.contact];
    c.queued = false;
    if (c.composite) return look_at_composite(world, check, dt);
    const Manifold manifold = manifold_ahead(world, c, dt);
    if (manifold.count == 0)
        for (int k = 0; k < 3; k++) check.direction[k] = static_cast<float>(manifold.normal[k]);
    check.near = smallest_gap(manifold);
    check.gap_ahead = expected_gap(world, c, manifold, dt);
    if (manifold.count > 0 && c.colour >= 0) {
        check.goes_on = true;
        write_manifold(world, c, manifold, false);
        check.done = is_in_its_list(world, c);
    } else if (check.gap_ahead < tuning::speculative_margin) {
        check.list = world.scratch.fresh_count.fetch_add(1, std::memory_order_relaxed);
        world.scratch.fresh[static_cast<std::size_t>(check.list)] = manifold;
    }
}

// ---- what came of it ----

// A plane has no box; b is the only one that can be a plane.
bool boxes_overlap(const WorldState& world, const Contact& c) {
    const ShapeRecord &a = world.shapes.shapes[c.shape_a], &b = world.shapes.shapes[c.shape_b];
    if (is_plane(b)) return reaches_plane(world, b, a.fat);
    return overlap(a.fat, b.fat);
}

// No manifold (any more): the pair waits until its bodies may have come near, or ends when its
// boxes parted.
void bound_or_end(WorldState& world, const ContactCheck& check, double near) {
    Contact& c = world.contacts.contacts[check.contact];
    if (c.touching) {
        report_end(world, c, world.events.contacts_ended);
        end_touch(world, check.contact);
    }
    if (c.colour >= 0) remove_contact(world, check.contact);
    if (!boxes_overlap(world, c)) {
        destroy_contact(world, check.contact, world.events.contacts_ended);
        return;
    }
    const float* d = check.direction;
    add_separation_bound(world, check.contact, check.near - near,
                         {double{d[0]}, double{d[1]}, double{d[2]}});
}

std::uint32_t index_of(const WorldState& world, const ContactCheck& check) {
    return static_cast<std::uint32_t>(&check - world.scratch.checks.data());
}

// Whether a body sleeps or is frozen.
bool is_asleep(const BodyCold& cold) {
    return cold.set == BodySet::sleeping || cold.asleep_in_place;
}

bool has_asleep(const WorldState& world, const Contact& c) {
    return is_asleep(world.bodies.cold[c.body_a]) || is_asleep(world.bodies.cold[c.body_b]);
}

// A kinematic body stops for nobody.
double mass_as_mover(const WorldState& world, std::uint32_t mover, std::uint32_t met) {
    constexpr double unstoppable = 100;
    const BodyCold& cold = world.bodies.cold[mover];
    return cold.type == BodyType::dynamic ? cold.mass : unstoppable * world.bodies.cold[met].mass;
}

// Whether a manifold begins. One with a body that sleeps or is frozen begins only when they meet,
// and wakes it and as much around it as the impact will stir.
bool begins(WorldState& world, const Contact& c, double gap_ahead) {
    if (!has_asleep(world, c)) return gap_ahead < tuning::speculative_margin;
    const double speed = closing_way(world, c, 1);
    // What comes to rest beside a sleeper, however near, does not wake it.
    if (gap_ahead >= (speed < tuning::sleep_speed ? 0 : tuning::wake_gap)) return false;
    const auto meet = [&](std::uint32_t body, std::uint32_t other) {
        const BodyCold& cold = world.bodies.cold[body];
        if (!is_asleep(cold)) return;
        if (cold.set == BodySet::sleeping) world.scratch.to_wake.push_back(cold.island);
        world.scratch.hits.push_back(
            {body, mass_stirred_by(speed * mass_as_mover(world, other, body))});
    };
    meet(c.body_a, c.body_b);
    meet(c.body_b, c.body_a);
    return true;
}

// Within which gap a manifold of the pair begins, m.
double begin_margin(const WorldState& world, const Contact& c) {
    return has_asleep(world, c) ? tuning::wake_gap : tuning::speculative_margin;
}

// Parts that found no manifold end, manifolds without a part begin one when they may touch in this
// step, and the pair waits until something new may come near.
void decide_composite(WorldState& world, ContactCheck& check) {
    auto& contacts = world.contacts.contacts;
    const auto& found = world.scratch.parts[static_cast<std::size_t>(check.list)];
    for (std::uint32_t p = contacts[check.contact].first_part; p != none;) {
        const std::uint32_t next = contacts[p].next_part;
        const bool goes_on = std::any_of(found.begin(), found.end(),
                                         [&](const FoundPart& f) { return f.contact == p; });
        if (goes_on)
            move_to_its_list(world, p);
        else
            destroy_contact(world, p, world.events.contacts_ended);
        p = next;
    }
    if (found.empty() && !boxes_overlap(world, contacts[check.contact])) {
        return destroy_contact(world, check.contact, world.events.contacts_ended);
    }
    double clear = check.near;
    const double margin = begin_margin(world, contacts[check.contact]);
    for (std::size_t k = 0; k < found.size(); k++) {
        if (found[k].contact != none) continue;
        if (begins(world, contacts[check.contact], found[k].gap_ahead))
            world.scratch.new_lanes.push_back(
                {index_of(world, check), static_cast<std::int32_t>(k)});
        else
            clear = minimum(clear, found[k].gap_ahead - margin);
    }
    add_separation_bound(world, check.contact, clear);
}

void decide(WorldState& world, ContactCheck& check) {
    const Contact& c = world.contacts.contacts[check.contact];
    if (c.composite) return decide_composite(world, check);
    // A manifold that exists stays while it has points; a new one begins when they may meet in this
    // step.
    if (check.goes_on) return move_to_its_list(world, check.contact);
    if (check.list >= 0 && begins(world, c, check.gap_ahead)) {
        world.scratch.new_lanes.push_back({index_of(world, check), -1});
        return;
    }
    bound_or_end(world, check, begin_margin(world, c));
}

void wake_islands(WorldState& world) {
    auto& islands = world.scratch.to_wake;
    std::sort(islands.begin(), islands.end());
    islands.erase(std::unique(islands.begin(), islands.end()), islands.end());
    for (const std::uint32_t island : islands) wake_island(world, island, world.events.woke);
    auto& hits = world.scratch.hits;
    std::sort(hits.begin(), hits.end());
    for (const Disturbance& hit : hits)
        if (world.bodies.cold[hit.body].asleep_in_place)
            wake_around(world, hit.body, hit.mass, world.events.woke);
}

// In order of shapes, so that colours and lanes do not depend on the order of the waiting list.
void begin_manifolds(WorldState& world) {
    auto& fresh = world.scratch.new_lanes;
    const auto key = [&](const NewLane& lane) {
        const Contact& c = world.contacts.contacts[world.scratch.checks[lane.check].contact];
        return std::tuple(c.shape_a, c.shape_b, lane.part);
    };
    std::sort(fresh.begin(), fresh.end(),
              [&](const NewLane& x, const NewLane& y) { return key(x) < key(y); });
    for (const NewLane& lane : fresh) {
        const ContactCheck& check = world.scratch.checks[lane.check];
        std::uint32_t contact = check.contact;
        const auto list = static_cast<std::size_t>(check.list);
        const Manifold* manifold = nullptr;
        if (lane.part >= 0) {
            const PartManifold& part =
                world.scratch.parts[list][static_cast<std::size_t>(lane.part)].part;
            contact = create_part(world, check.contact, part.key);
            manifold = &part.manifold;
        } else {
            manifold = &world.scratch.fresh[list];
        }
        const Contact& c = world.contacts.contacts[contact];
        if (world.bodies.cold[c.body_b].type == BodyType::dynamic)
            match_sets(world, world.bodies.cold[c.body_a].island,
                       world.bodies.cold[c.body_b].island);
        add_contact(world, contact, manifold->count == 1);
        write_manifold(world, world.contacts.contacts[contact], *manifold, true);
    }
}

}  // namespace

Skipped update_contacts(StepContext& step) {
    if (step.world.bodies.awake.empty()) return nobody_awake;
    WorldState& world = step.world;
    auto& checks = world.scratch.checks;
    checks.clear();
    world.scratch.part_lists = 0;
    world.scratch.new_lanes.clear();
    world.scratch.to_wake.clear();
    world.scratch.hits.clear();
    note_held(world);
    drop_dormant_pairs(world);
    take_due_pairs(step);
    take_manifolds_to_rebuild(world);
    make_space(world.scratch);
    step.team.run(static_cast<int>(checks.size()), 32, [&](int begin, int end) {
        for (int k = begin; k < end; k++) {
            prefetch_ahead(world, k, end);
            look(world, checks[static_cast<std::size_t>(k)], step.dt);
        }
    });
    for (std::size_t k = 0; k < checks.size(); k++) {
        if (k + 8 < checks.size() && !checks[k + 8].done)
            prefetch(world.contacts.contacts[checks[k + 8].contact]);
        if (!checks[k].done) decide(world, checks[k]);
    }
    wake_islands(world);
    begin_manifolds(world);
    world.profile.pairs_checked = static_cast<int>(checks.size());
    return ran;
}

}  // namespace jostle::physics
