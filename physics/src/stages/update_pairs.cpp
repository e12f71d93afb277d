// SPDX-License-Identifier: MIT
#include "stages/update_pairs.h"

#include <algorithm>

#include "state/frozen.h"
#include "state/links.h"
#include "state/reach.h"

namespace jostle::physics {
namespace {

void add_pair(WorldState& world, std::uint32_t a, std::uint32_t b) {
    const ShapeRecord &sa = world.shapes.shapes[a], &sb = world.shapes.shapes[b];
    if (sa.body == sb.body) return;
    if (world.bodies.cold[sa.body].type != BodyType::dynamic &&
        world.bodies.cold[sb.body].type != BodyType::dynamic)
        return;
    if (!may_meet(sa.filter, sb.filter) || sa.trigger || sb.trigger) return;
    if (world.contacts.pairs.contains(pair_key(a, b))) return;
    if (joined_without_contact(world, sa.body, sb.body)) return;
    world.scratch.new_pairs.emplace_back(std::min(a, b), std::max(a, b));
}

void find_neighbours(WorldState& world, std::uint32_t index) {
    const ShapeStore& store = world.shapes;
    const ShapeRecord& shape = store.shapes[index];
    if (shape.trigger) return;  // looked at by update_triggers
    const bool fixed = world.bodies.cold[shape.body].type == BodyType::fixed;
    if (is_plane(shape)) {
        for (std::uint32_t other = 0; other < store.ids.size(); other++)
            if (store.ids.alive(other) && !is_plane(store.shapes[other]) &&
                reaches_plane(world, shape, store.shapes[other].fat))
                add_pair(world, index, other);
        return;
    }
    // A positive group collides whatever the mask says.
    const std::uint32_t mask = shape.filter.group > 0 ? 0xffffffff : shape.filter.mask;
    std::vector<std::uint32_t>& found = world.scratch.found;
    found.clear();
    store.moving->query(shape.fat, mask, found);
    if (!fixed) store.fixed->query(shape.fat, mask, found);
    for (const std::uint32_t other : found) add_pair(world, index, other);
    if (fixed) return;
    for (const std::uint32_t plane : store.planes)
        if (reaches_plane(world, store.shapes[plane], shape.fat)) add_pair(world, index, plane);
}

// A pair that nobody awake takes part in: something new stands beside a sleeper. It wakes to look.
void wake_if_all_asleep(WorldState& world, const Contact& c) {
    for (const std::uint32_t body : {c.body_a, c.body_b}) {
        const BodyCold& cold = world.bodies.cold[body];
        if (cold.set == BodySet::awake && !cold.frozen) return;
    }
    rouse(world, c.body_a, world.events.woke);
}

}  // namespace

Skipped update_pairs(StepContext& step) {
    WorldState& world = step.world;
    std::vector<std::uint32_t>& moved = world.shapes.moved;
    world.profile.pairs = static_cast<int>(world.contacts.ids.alive_count());
    if (moved.empty()) return "no shape left its fat box";
    world.shapes.fixed->settle();
    world.shapes.moving->settle();
    auto& pairs = world.scratch.new_pairs;
    pairs.clear();
    for (const std::uint32_t shape : moved) find_neighbours(world, shape);
    for (const std::uint32_t shape : moved) world.shapes.shapes[shape].moved = false;
    moved.clear();
    // Sorted: contact indices must not depend on the shape of a tree.
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    for (const auto& [a, b] : pairs) {
        const std::uint32_t contact = create_contact(world, a, b);
        wake_if_all_asleep(world, world.contacts.contacts[contact]);
    }
    world.profile.pairs = static_cast<int>(world.contacts.ids.alive_count());
    return ran;
}

}  // namespace jostle::physics
