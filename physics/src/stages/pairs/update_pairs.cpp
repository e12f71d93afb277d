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

bool is_fixed(const WorldState& world, std::uint32_t shape) {
    return world.bodies.cold[world.shapes.shapes[shape].body].type != BodyType::dynamic;
}

// Number of pairs that may be added (WorldDef::max_pairs_per_shape). Pairs with a body that is not
// dynamic may use twice the limit, so that no body falls through a floor because many others
// overlap.
struct PairRoom {
    std::size_t any, fixed;

    PairRoom less(std::size_t count) const {
        return {any - std::min(any, count), fixed - std::min(fixed, count)};
    }
};

PairRoom pair_room(const WorldState& world) {
    constexpr std::size_t unlimited = ~std::size_t{0};
    const auto per_shape = static_cast<std::size_t>(world.def.max_pairs_per_shape);
    if (per_shape == 0) return {unlimited, unlimited};
    const std::size_t limit = tuning::min_pair_limit + per_shape * world.shapes.ids.alive_count();
    return PairRoom{limit, 2 * limit}.less(world.contacts.pairs.size());
}

// Which pairs of one shape are added: all of a kind or none, because the order of the results of a
// query is unspecified.
struct AddedKinds {
    bool dynamic, fixed;
};

void add_pair(const WorldState& world, std::uint32_t a, std::uint32_t b, AddedKinds kinds,
              NewPairs& out) {
    ASSERT(world.shapes.ids.alive(a) && world.shapes.ids.alive(b));
    const ShapeRecord &sa = world.shapes.shapes[a], &sb = world.shapes.shapes[b];
    if (sa.body == sb.body) return;
    const bool fixed_a = is_fixed(world, a), fixed_b = is_fixed(world, b);
    if (fixed_a && fixed_b) return;
    if (!may_collide(sa.filter, sb.filter) || sa.trigger || sb.trigger) return;
    if (world.contacts.pairs.contains(pair_key(a, b))) return;
    if (joined_without_contact(world.bodies, world.joints, sa.body, sb.body)) return;
    if (fixed_a || fixed_b ? kinds.fixed : kinds.dynamic)
        out.pairs.emplace_back(std::min(a, b), std::max(a, b));
    else
        out.skipped++;
}

void find_neighbours(const WorldState& world, std::uint32_t index, PairRoom room, NewPairs& out) {
    const ShapeStore& store = world.shapes;
    const ShapeRecord& shape = store.shapes[index];
    ASSERT(store.ids.alive(index) && shape.moved);
    if (shape.trigger) return;  // handled by update_triggers
    const AddedKinds kinds{out.pairs.size() < room.any, out.pairs.size() < room.fixed};
    const bool fixed = world.bodies.cold[shape.body].type == BodyType::static_body;
    if (is_plane(shape)) {
        for (std::uint32_t other = 0; other < store.ids.size(); other++)
            if (store.ids.alive(other) && !is_plane(store.shapes[other]) &&
                reaches_plane(world, shape, store.shapes[other].fat))
                add_pair(world, index, other, kinds, out);
        return;
    }
    // Shapes in the same positive group collide regardless of the mask.
    const std::uint32_t mask = shape.filter.group > 0 ? 0xffffffff : shape.filter.mask;
    out.near.clear();
    store.moving->query(shape.fat, mask, out.near);
    if (!fixed) store.statics->query(shape.fat, mask, out.near);
    for (const std::uint32_t other : out.near) add_pair(world, index, other, kinds, out);
    if (fixed) return;
    for (const std::uint32_t plane : store.planes)
        if (reaches_plane(world, store.shapes[plane], shape.fat))
            add_pair(world, index, plane, kinds, out);
}

// Removes the last pairs in canonical order that exceed the room, those of dynamic bodies first.
void limit_pairs(const WorldState& world, PairRoom room, NewPairs& out) {
    std::vector<ShapePair>& pairs = out.pairs;
    if (pairs.size() <= room.any) return;
    const auto dynamic =
        std::stable_partition(pairs.begin(), pairs.end(), [&](const ShapePair& pair) {
            return is_fixed(world, pair.first) || is_fixed(world, pair.second);
        });
    const auto fixed = static_cast<std::size_t>(dynamic - pairs.begin());
    const std::size_t kept = std::min(std::max(fixed, room.any), room.fixed);
    if (kept >= pairs.size()) return;
    out.skipped += pairs.size() - kept;
    pairs.resize(kept);
    std::sort(pairs.begin(), pairs.end());
}

// The new pairs of all moved shapes, each once, in a canonical order: contact indices must not
// depend on the structure of a tree or on threads.
const NewPairs& find_new_pairs(StepContext& step) {
    constexpr std::size_t chunk = tuning::pair_grain;
    const WorldState& world = step.world;
    const std::vector<std::uint32_t>& moved = world.shapes.moved;
    ASSERT(!moved.empty());
    const PairRoom room = pair_room(world);
    std::vector<NewPairs>& parts = step.scratch.pairs.new_pairs;
    const std::size_t chunks = (moved.size() + chunk - 1) / chunk;
    if (parts.size() < chunks) parts.resize(chunks);
    for (NewPairs& part : parts) {
        part.pairs.clear();
        part.skipped = 0;
    }
    const std::size_t at_once = world.def.max_pairs_per_shape == 0
                                    ? chunks
                                    : static_cast<std::size_t>(tuning::limited_pair_grains);
    NewPairs& all = parts.front();
    for (std::size_t first = 0; first < chunks; first += at_once) {
        const std::size_t last = std::min(first + at_once, chunks);
        // Most pairs are found twice, once by each shape.
        const PairRoom left = room.less(all.pairs.size() / 2);
        step.thread_pool.run(static_cast<int>(last - first), 1, [&](int begin, int end) {
            for (std::size_t part = first + static_cast<std::size_t>(begin);
                 part < first + static_cast<std::size_t>(end); part++)
                for (std::size_t k = part * chunk; k < std::min((part + 1) * chunk, moved.size());
                     k++)
                    find_neighbours(world, moved[k], left, parts[part]);
        });
        for (std::size_t k = std::max<std::size_t>(first, 1); k < last; k++) {
            all.pairs.insert(all.pairs.end(), parts[k].pairs.begin(), parts[k].pairs.end());
            all.skipped += parts[k].skipped;
        }
    }
    std::sort(all.pairs.begin(), all.pairs.end());
    all.pairs.erase(std::unique(all.pairs.begin(), all.pairs.end()), all.pairs.end());
    limit_pairs(world, room, all);
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
    const auto& [pairs, near, skipped] = find_new_pairs(step);
    world.profile.pairs_skipped = static_cast<int>(skipped);
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
