// SPDX-License-Identifier: MIT
#include "physics/src/stages/stages.h"

#include <algorithm>

#include "jostle/base/check.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/contact_graph.h"
#include "physics/src/state/joint_graph.h"
#include "physics/src/state/shape_proxy.h"

namespace jostle::physics {
namespace {

using ShapePair = std::pair<std::uint32_t, std::uint32_t>;

void add_pair(const WorldState& world, std::uint32_t a, std::uint32_t b,
              std::vector<ShapePair>& pairs) {
    ASSERT(world.shapes.ids.alive(a) && world.shapes.ids.alive(b));
    const ShapeRecord &sa = world.shapes.shapes[a], &sb = world.shapes.shapes[b];
    if (sa.body == sb.body) return;
    if (world.bodies.cold[sa.body].type != BodyType::dynamic &&
        world.bodies.cold[sb.body].type != BodyType::dynamic)
        return;
    if (!may_collide(sa.filter, sb.filter) || sa.trigger || sb.trigger) return;
    if (world.contacts.pairs.contains(pair_key(a, b))) return;
    if (joined_without_contact(world.bodies, world.joints, sa.body, sb.body)) return;
    pairs.emplace_back(std::min(a, b), std::max(a, b));
}

void find_neighbours(const WorldState& world, std::uint32_t index, NewPairs& out) {
    const ShapeStore& store = world.shapes;
    const ShapeRecord& shape = store.shapes[index];
    ASSERT(store.ids.alive(index) && shape.moved);
    if (shape.trigger) return;  // handled by update_triggers
    const bool fixed = world.bodies.cold[shape.body].type == BodyType::static_body;
    if (is_plane(shape)) {
        for (std::uint32_t other = 0; other < store.ids.size(); other++)
            if (store.ids.alive(other) && !is_plane(store.shapes[other]) &&
                reaches_plane(world, shape, store.shapes[other].fat))
                add_pair(world, index, other, out.pairs);
        return;
    }
    // Shapes in the same positive group collide regardless of the mask.
    const std::uint32_t mask = shape.filter.group > 0 ? 0xffffffff : shape.filter.mask;
    out.near.clear();
    store.moving->query(shape.fat, mask, out.near);
    if (!fixed) store.statics->query(shape.fat, mask, out.near);
    for (const std::uint32_t other : out.near) add_pair(world, index, other, out.pairs);
    if (fixed) return;
    for (const std::uint32_t plane : store.planes)
        if (reaches_plane(world, store.shapes[plane], shape.fat))
            add_pair(world, index, plane, out.pairs);
}

// The new pairs of all moved shapes, each once, in a canonical order: contact indices must not
// depend on the structure of a tree or on threads.
const std::vector<ShapePair>& find_new_pairs(StepContext& step) {
    constexpr std::size_t chunk = tuning::pair_grain;
    const WorldState& world = step.world;
    const std::vector<std::uint32_t>& moved = world.shapes.moved;
    ASSERT(!moved.empty());
    std::vector<NewPairs>& parts = step.scratch.pairs.new_pairs;
    const std::size_t chunks = (moved.size() + chunk - 1) / chunk;
    if (parts.size() < chunks) parts.resize(chunks);
    for (NewPairs& part : parts) part.pairs.clear();
    step.thread_pool.run(static_cast<int>(chunks), 1, [&](int begin, int end) {
        for (auto part = static_cast<std::size_t>(begin); part < static_cast<std::size_t>(end);
             part++)
            for (std::size_t k = part * chunk; k < std::min((part + 1) * chunk, moved.size()); k++)
                find_neighbours(world, moved[k], parts[part]);
    });
    std::vector<ShapePair>& all = parts.front().pairs;
    for (std::size_t k = 1; k < parts.size(); k++)
        all.insert(all.end(), parts[k].pairs.begin(), parts[k].pairs.end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

// A new shape may appear next to sleeping bodies. If no body of the pair is awake, wakes one so
// that the pair is tested.
void wake_if_all_asleep(const BodyStore& bodies, const Contact& c, WakeRequests& requests) {
    for (const std::uint32_t body : {c.body_a, c.body_b}) {
        const BodyCold& cold = bodies.cold[body];
        if (cold.set == BodySet::awake && !cold.asleep_in_place) return;
    }
    requests.push_back({c.body_a});
}

}  // namespace

Skipped update_pairs(StepContext& step) {
    WorldState& world = step.world;
    std::vector<std::uint32_t>& moved = world.shapes.moved;
    world.profile.pairs = static_cast<int>(world.contacts.ids.alive_count());
    if (moved.empty()) return "no shape left its fat box";
    world.shapes.statics->flush();
    world.shapes.moving->flush();
    const std::vector<ShapePair>& pairs = find_new_pairs(step);
    ASSERT(std::is_sorted(pairs.begin(), pairs.end()));
    for (const std::uint32_t shape : moved) world.shapes.shapes[shape].moved = false;
    moved.clear();
    for (const auto& [a, b] : pairs) {
        const std::uint32_t contact = create_contact(world, a, b);
        const Contact& c = world.contacts.contacts[contact];
        ASSERT(c.has_bound);
        wake_if_all_asleep(world.bodies, c, world.wake_requests);
    }
    ASSERT(world.contacts.pairs.size() <= world.contacts.ids.alive_count());
    world.profile.pairs = static_cast<int>(world.contacts.ids.alive_count());
    return ran;
}

}  // namespace jostle::physics
