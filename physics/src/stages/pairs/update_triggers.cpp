// SPDX-License-Identifier: MIT
#include "physics/src/stages/stages.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/collision/narrowphase/collide_composite.h"
#include "physics/src/collision/narrowphase/passes_through.h"
#include "physics/src/constraints/free_motion.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/geometry/shape_measures.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/shape_proxy.h"

namespace jostle::physics {
namespace {

// ---- the motions of bodies in the step ----

const ToiBody* find_deflected(const TriggerScratch& scratch, std::uint32_t body) {
    const auto& deflected = scratch.deflected;
    const auto at = std::lower_bound(deflected.begin(), deflected.end(), body,
                                     [](const ToiBody* t, std::uint32_t b) { return t->body < b; });
    return at != deflected.end() && (*at)->body == body ? *at : nullptr;
}

void list_deflected(const std::vector<ToiBody>& bodies, TriggerScratch& scratch) {
    scratch.deflected.clear();
    for (const ToiBody& t : bodies) scratch.deflected.push_back(&t);
    std::sort(scratch.deflected.begin(), scratch.deflected.end(),
              [](const ToiBody* a, const ToiBody* b) { return a->body < b->body; });
}

bool has_moved(const StepScratch& scratch, std::uint32_t body) {
    const auto& starts = scratch.finalize.path_starts;
    return (body < starts.size() && starts[body].moved) ||
           find_deflected(scratch.pairs.triggers, body) != nullptr;
}

// Calls visit(Sweep) for each part of the body's path, from the start of the step to its end.
template <class Visit>
void for_each_leg(const StepContext& step, std::uint32_t body, Visit&& visit) {
    if (const ToiBody* t = find_deflected(step.scratch.pairs.triggers, body)) {
        for (const Sweep& leg : t->past) visit(leg);
        Sweep last = t->sweep;
        last.until = 1;
        visit(last);
        return;
    }
    const BodyWarm& now = warm_of(step.world, body);
    const auto& starts = step.scratch.finalize.path_starts;
    if (body >= starts.size() || !starts[body].moved)
        return visit(Sweep{0, now.center, now.rotation, {}, {}});
    const PathStart& start = starts[body];
    visit(Sweep{0, start.center, start.rotation, now.center - start.center,
                rotation_vector_between(start.rotation, now.rotation, now.w * step.dt)});
}

SweptShape swept_shape(const ShapedBodies& stores, std::uint32_t shape, const Sweep& sweep) {
    const ShapeRecord& s = stores.shapes.shapes[shape];
    return {&s.geometry, s.offset, s.axes, stores.bodies.cold[s.body].radius, sweep};
}

// The box around the path of a shape that is not a plane.
Aabb path_box(const StepContext& step, std::uint32_t shape) {
    const ShapeRecord& record = step.world.shapes.shapes[shape];
    Aabb box = bounds_of(transformed_shape(record, warm_of(step.world, record.body)));
    if (!has_moved(step.scratch, record.body)) return box;
    for_each_leg(step, record.body, [&](const Sweep& leg) {
        box = unite(box, swept_bounds(swept_shape(step.world, shape, leg), leg.from, leg.until));
    });
    return box;
}

// ---- pairs that may overlap ----

// Returns whether the trigger reports the shape at all.
bool reports(const ShapedBodies& stores, std::uint32_t trigger, std::uint32_t other) {
    ASSERT(stores.shapes.ids.alive(other));
    const ShapeRecord &t = stores.shapes.shapes[trigger], &o = stores.shapes.shapes[other];
    if (o.trigger || o.body == t.body || !may_collide(t.filter, o.filter)) return false;
    return stores.bodies.cold[t.body].type != BodyType::static_body ||
           stores.bodies.cold[o.body].type != BodyType::static_body;
}

// Shapes whose fat boxes overlap the path of the trigger.
void find_near(const ShapedBodies& stores, const ShapePath& trigger,
               std::vector<std::uint32_t>& found) {
    const ShapeRecord& shape = stores.shapes.shapes[trigger.shape];
    ASSERT(shape.trigger);
    found.clear();
    if (is_plane(shape)) {
        for (std::uint32_t s = 0; s < stores.shapes.ids.size(); s++)
            if (stores.shapes.ids.alive(s) && !is_plane(stores.shapes.shapes[s]) &&
                reaches_plane(stores, shape, stores.shapes.shapes[s].fat))
                found.push_back(s);
        return;
    }
    stores.shapes.moving->query(trigger.box, 0xffffffff, found);
    if (stores.bodies.cold[shape.body].type == BodyType::static_body) return;
    stores.shapes.statics->query(trigger.box, 0xffffffff, found);
    for (const std::uint32_t plane : stores.shapes.planes)
        if (reaches_plane(stores, stores.shapes.shapes[plane], trigger.box)) found.push_back(plane);
}

// Shapes that may have left the fat boxes in the trees within the step.
void list_far_shapes(const StepContext& step, std::vector<ShapePath>& far) {
    const auto& starts = step.scratch.finalize.path_starts;
    const auto add = [&](std::uint32_t body) {
        for (std::uint32_t s = step.world.bodies.cold[body].first_shape; s != none;
             s = step.world.shapes.shapes[s].next) {
            const ShapeRecord& shape = step.world.shapes.shapes[s];
            if (!shape.trigger && !is_plane(shape)) far.push_back({s, path_box(step, s)});
        }
    };
    far.clear();
    for (const std::uint32_t body : step.scratch.finalize.path_bodies)
        if (starts[body].moved && starts[body].far) add(body);
    for (const ToiBody* t : step.scratch.pairs.triggers.deflected) add(t->body);
}

// Calls visit(a, b) for each two overlapping boxes of two lists. Sorts the lists.
template <class Visit>
void for_each_overlap(std::vector<ShapePath>& a, std::vector<ShapePath>& b, Visit&& visit) {
    for (std::vector<ShapePath>* list : {&a, &b})
        std::sort(list->begin(), list->end(),
                  [](const ShapePath& x, const ShapePath& y) { return x.box.low.x < y.box.low.x; });
    const auto scan = [&](const ShapePath& one, const std::vector<ShapePath>& others,
                          std::size_t from, auto&& found) {
        for (std::size_t k = from; k < others.size(); k++) {
            if (others[k].box.low.x > one.box.high.x) break;
            if (overlap(one.box, others[k].box)) found(others[k]);
        }
    };
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();)
        if (a[i].box.low.x < b[j].box.low.x) {
            scan(a[i], b, j, [&](const ShapePath& other) { visit(a[i].shape, other.shape); });
            i++;
        } else {
            scan(b[j], a, i, [&](const ShapePath& other) { visit(other.shape, b[j].shape); });
            j++;
        }
}

// Writes TriggerScratch::pairs.
void find_pairs(StepContext& step) {
    const WorldState& world = step.world;
    TriggerScratch& scratch = step.scratch.pairs.triggers;
    scratch.triggers.clear();
    scratch.pairs.clear();
    for (const std::uint32_t shape : world.shapes.triggers) {
        const bool plane = is_plane(world.shapes.shapes[shape]);
        const ShapePath trigger{shape, plane ? Aabb{} : path_box(step, shape)};
        find_near(world, trigger, scratch.near);
        for (const std::uint32_t other : scratch.near)
            if (reports(world, shape, other)) scratch.pairs.push_back({shape, other});
        if (!plane) scratch.triggers.push_back(trigger);
    }
    list_far_shapes(step, scratch.far);
    const auto add = [&](std::uint32_t trigger, std::uint32_t other) {
        if (reports(world, trigger, other)) scratch.pairs.push_back({trigger, other});
    };
    if (!scratch.far.empty()) for_each_overlap(scratch.triggers, scratch.far, add);
    for (const std::uint32_t shape : world.shapes.triggers)
        if (is_plane(world.shapes.shapes[shape]))
            for (const ShapePath& far : scratch.far)
                if (reaches_plane(world, world.shapes.shapes[shape], far.box))
                    add(shape, far.shape);
    std::sort(scratch.pairs.begin(), scratch.pairs.end());
    scratch.pairs.erase(std::unique(scratch.pairs.begin(), scratch.pairs.end()),
                        scratch.pairs.end());
}

// ---- presence ----

enum class Presence : std::uint8_t {
    outside,
    inside,   // at the end of the step
    passing,  // only within the step
};

bool overlap_now(const ShapedBodies& stores, std::uint32_t a, std::uint32_t b) {
    const ShapeRecord &sa = stores.shapes.shapes[a], &sb = stores.shapes.shapes[b];
    return shapes_overlap(transformed_shape(sa, warm_of(stores, sa.body)),
                          transformed_shape(sb, warm_of(stores, sb.body)));
}

bool overlap_within_step(const StepContext& step, const Inside& pair) {
    const ShapedBodies& stores = step.world;
    const ShapeRecord &trigger = stores.shapes.shapes[pair.trigger],
                      &shape = stores.shapes.shapes[pair.shape];
    if (!is_plane(trigger) && !is_plane(shape) &&
        !overlap(path_box(step, pair.trigger), path_box(step, pair.shape)))
        return false;
    bool passes = false;
    for_each_leg(step, trigger.body, [&](const Sweep& a) {
        for_each_leg(step, shape.body, [&](const Sweep& b) {
            const double from = maximum(a.from, b.from), until = minimum(a.until, b.until);
            passes = passes || (from < until &&
                                passes_through(swept_shape(stores, pair.trigger, a),
                                               swept_shape(stores, pair.shape, b), from, until));
        });
    });
    return passes;
}

Presence presence_of(const StepContext& step, const Inside& pair) {
    const ShapedBodies& stores = step.world;
    const auto& previous = stores.triggers.inside;
    const auto& fresh = stores.triggers.fresh;
    const std::uint32_t own = stores.shapes.shapes[pair.trigger].body,
                        body = stores.shapes.shapes[pair.shape].body;
    const bool was_inside = std::binary_search(previous.begin(), previous.end(), pair);
    const bool move = has_moved(step.scratch, own) || has_moved(step.scratch, body);
    // Between two shapes that do not move nothing changes.
    const bool awake = stores.bodies.cold[own].set == BodySet::awake ||
                       stores.bodies.cold[body].set == BodySet::awake;
    if (!move && !awake && std::find(fresh.begin(), fresh.end(), pair.trigger) == fresh.end())
        return was_inside ? Presence::inside : Presence::outside;
    if (overlap_now(stores, pair.trigger, pair.shape)) return Presence::inside;
    if (was_inside || !move || !overlap_within_step(step, pair)) return Presence::outside;
    return Presence::passing;
}

void find_presences(StepContext& step) {
    TriggerScratch& scratch = step.scratch.pairs.triggers;
    scratch.presence.resize(scratch.pairs.size());
    step.thread_pool.run(static_cast<int>(scratch.pairs.size()), tuning::narrow_phase_grain,
                         [&](int begin, int end) {
                             for (auto k = static_cast<std::size_t>(begin);
                                  k < static_cast<std::size_t>(end); k++)
                                 scratch.presence[k] =
                                     static_cast<std::uint8_t>(presence_of(step, scratch.pairs[k]));
                         });
}

TriggerEvent event_of(const ShapedBodies& stores, const Inside& pair) {
    ASSERT(stores.shapes.ids.alive(pair.trigger) && stores.shapes.ids.alive(pair.shape));
    const std::uint32_t own = stores.shapes.shapes[pair.trigger].body,
                        body = stores.shapes.shapes[pair.shape].body;
    return {shape_id(stores.shapes, pair.trigger), shape_id(stores.shapes, pair.shape),
            body_id(stores.bodies, own), body_id(stores.bodies, body)};
}

void forget_paths(FinalizeScratch& scratch) {
    for (const std::uint32_t body : scratch.path_bodies) scratch.path_starts[body] = {};
    scratch.path_bodies.clear();
}

}  // namespace

Skipped update_triggers(StepContext& step) {
    WorldState& world = step.world;
    if (world.shapes.triggers.empty() && world.triggers.inside.empty()) return "no triggers";
    ASSERT(std::is_sorted(world.triggers.inside.begin(), world.triggers.inside.end()));
    world.shapes.statics->flush();
    world.shapes.moving->flush();
    TriggerScratch& scratch = step.scratch.pairs.triggers;
    list_deflected(step.scratch.continuous.changed, scratch);
    find_pairs(step);
    find_presences(step);
    const std::vector<Inside>& previous = world.triggers.inside;
    std::vector<Inside> inside;
    for (std::size_t k = 0; k < scratch.pairs.size(); k++) {
        const Inside& pair = scratch.pairs[k];
        const auto presence = static_cast<Presence>(scratch.presence[k]);
        if (presence == Presence::outside) continue;
        const TriggerEvent event = event_of(world, pair);
        if (presence == Presence::passing) {
            world.events.triggers_entered.push_back(event);
            world.events.triggers_left.push_back(event);
            continue;
        }
        inside.push_back(pair);
        (std::binary_search(previous.begin(), previous.end(), pair) ? world.events.triggers_stayed
                                                                    : world.events.triggers_entered)
            .push_back(event);
    }
    for (const Inside& pair : previous)
        if (!std::binary_search(inside.begin(), inside.end(), pair))
            world.events.triggers_left.push_back(event_of(world, pair));
    world.triggers.inside = std::move(inside);
    world.triggers.fresh.clear();
    forget_paths(step.scratch.finalize);
    return ran;
}

}  // namespace jostle::physics
