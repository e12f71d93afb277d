// SPDX-License-Identifier: MIT
#include "physics/src/stages/stages.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/collision/narrowphase/collide_composite.h"
#include "physics/src/geometry/shape_measures.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/shape_proxy.h"

namespace jostle::physics {
namespace {

bool overlap_now(const ShapedBodies& stores, std::uint32_t a, std::uint32_t b) {
    const ShapeRecord &sa = stores.shapes.shapes[a], &sb = stores.shapes.shapes[b];
    const TransformedShape pa = transformed_shape(sa, warm_of(stores, sa.body)),
                           pb = transformed_shape(sb, warm_of(stores, sb.body));
    return shapes_overlap(pa, pb);
}

void test_trigger(const ShapedBodies& stores, std::uint32_t trigger,
                  std::vector<std::uint32_t>& found, std::vector<Inside>& inside) {
    const ShapeRecord& shape = stores.shapes.shapes[trigger];
    ASSERT(shape.trigger);
    const BodyCold& own = stores.bodies.cold[shape.body];
    const auto& previous = stores.triggers.inside;
    const bool fresh = std::find(stores.triggers.fresh.begin(), stores.triggers.fresh.end(),
                                 trigger) != stores.triggers.fresh.end();
    const auto consider = [&](std::uint32_t other) {
        ASSERT(stores.shapes.ids.alive(other));
        const ShapeRecord& o = stores.shapes.shapes[other];
        if (o.trigger || o.body == shape.body || !may_collide(shape.filter, o.filter)) return;
        const BodyCold& body = stores.bodies.cold[o.body];
        if (own.type == BodyType::static_body && body.type == BodyType::static_body) return;
        // Between two shapes that do not move nothing changes.
        const Inside pair{trigger, other};
        const bool still = !fresh && own.set != BodySet::awake && body.set != BodySet::awake;
        const bool is_in = still ? std::binary_search(previous.begin(), previous.end(), pair)
                                 : overlap_now(stores, trigger, other);
        if (is_in) inside.push_back(pair);
    };
    found.clear();
    if (is_plane(shape)) {
        for (std::uint32_t s = 0; s < stores.shapes.ids.size(); s++)
            if (stores.shapes.ids.alive(s) && !is_plane(stores.shapes.shapes[s]) &&
                reaches_plane(stores, shape, stores.shapes.shapes[s].fat))
                found.push_back(s);
    } else {
        const Aabb box = bounds_of(transformed_shape(shape, warm_of(stores, shape.body)));
        stores.shapes.moving->query(box, 0xffffffff, found);
        if (own.type != BodyType::static_body) {
            stores.shapes.statics->query(box, 0xffffffff, found);
            for (const std::uint32_t plane : stores.shapes.planes)
                if (reaches_plane(stores, stores.shapes.shapes[plane], box)) found.push_back(plane);
        }
    }
    for (const std::uint32_t other : found) consider(other);
}

TriggerEvent event_of(const ShapedBodies& stores, const Inside& pair) {
    ASSERT(stores.shapes.ids.alive(pair.trigger) && stores.shapes.ids.alive(pair.shape));
    const std::uint32_t own = stores.shapes.shapes[pair.trigger].body,
                        body = stores.shapes.shapes[pair.shape].body;
    return {shape_id(stores.shapes, pair.trigger), shape_id(stores.shapes, pair.shape),
            body_id(stores.bodies, own), body_id(stores.bodies, body)};
}

}  // namespace

Skipped update_triggers(StepContext& step) {
    WorldState& world = step.world;
    if (world.shapes.triggers.empty() && world.triggers.inside.empty()) return "no triggers";
    ASSERT(std::is_sorted(world.triggers.inside.begin(), world.triggers.inside.end()));
    world.shapes.statics->flush();
    world.shapes.moving->flush();
    std::vector<Inside> inside;
    for (const std::uint32_t trigger : world.shapes.triggers)
        test_trigger(world, trigger, step.scratch.pairs.in_trigger, inside);
    std::sort(inside.begin(), inside.end());
    inside.erase(std::unique(inside.begin(), inside.end()), inside.end());
    const auto& previous = world.triggers.inside;
    for (const Inside& pair : inside)
        (std::binary_search(previous.begin(), previous.end(), pair) ? world.events.triggers_stayed
                                                                    : world.events.triggers_entered)
            .push_back(event_of(world, pair));
    for (const Inside& pair : previous)
        if (!std::binary_search(inside.begin(), inside.end(), pair))
            world.events.triggers_left.push_back(event_of(world, pair));
    world.triggers.inside = std::move(inside);
    world.triggers.fresh.clear();
    return ran;
}

}  // namespace jostle::physics
