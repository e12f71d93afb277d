// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <vector>

#include "jostle/base/check.h"
#include "physics/src/foundation/size_scale.h"
#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/islands/island_stages.h"
#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/island_tiers.h"
#include "physics/src/state/islands.h"

namespace jostle::physics {
namespace {

// Calls visit(contact, other body) for each manifold below the body.
template <class Visit>
void for_each_support(ContactGraph& stores, std::uint32_t body, Vec3 up, Visit&& visit) {
    for_each_manifold(stores.contacts, stores.bodies.cold[body], [&](std::uint32_t index) {
        const Contact& c = stores.contacts.contacts[index];
        const double rise = dot(normal_of(lane_ref_of(stores.graph, c)), up);
        // The normal points from a to b.
        if ((c.body_a == body ? -rise : rise) < tuning::lies_on) return;
        visit(c, c.body_a == body ? c.body_b : c.body_a);
    });
}

// Returns whether the body rests only on bodies that are a hundred times lighter.
bool is_heavy_load(ContactGraph& stores, std::uint32_t body, Vec3 up) {
    const double most = stores.bodies.cold[body].mass / tuning::heavy_ratio;
    bool on_light = false, on_firm = false;
    for_each_support(stores, body, up, [&](const Contact& c, std::uint32_t below) {
        if (!c.touching) return;
        const BodyCold& other = stores.bodies.cold[below];
        (other.type == BodyType::dynamic && other.mass <= most ? on_light : on_firm) = true;
    });
    return on_light && !on_firm;
}

// A body with what lies on it.
struct Loaded {
    std::uint32_t body = none;
    double height = 0;
    double load = 0;  // kg, of the bodies above
    int layers = 0;   // above it
};

template <class Visit>
void for_each_body(const BodySets& sets, std::span<const std::uint32_t> islands, Visit&& visit) {
    for (const std::uint32_t island : islands)
        for (std::uint32_t body = sets.islands.islands[island].first; body != none;
             body = sets.bodies.cold[body].island_next)
            visit(body);
}

}  // namespace

bool has_heavy_load(ContactGraph& stores, const Island& island, Vec3 up) {
    for (std::uint32_t body = island.first; body != none;
         body = stores.bodies.cold[body].island_next)
        if (is_heavy_load(stores, body, up)) return true;
    return false;
}

double largest_load_ratio(ContactGraph& stores, std::span<const std::uint32_t> islands, Vec3 up) {
    std::vector<Loaded> bodies;
    for_each_body(stores, islands, [&](std::uint32_t body) {
        bodies.push_back({body, dot(up, warm_of(stores, body).center), 0, 0});
    });
    std::sort(bodies.begin(), bodies.end(), [](const Loaded& a, const Loaded& b) {
        return a.height != b.height ? a.height > b.height : a.body < b.body;
    });
    const auto find = [&](std::uint32_t body) -> Loaded* {
        const auto at = std::find_if(bodies.begin(), bodies.end(),
                                     [&](const Loaded& other) { return other.body == body; });
        return at != bodies.end() ? &*at : nullptr;
    };
    double largest = 0;
    for (Loaded& own : bodies) {
        const double mass = stores.bodies.cold[own.body].mass;
        ASSERT(mass > 0);
        if (own.layers > 0) largest = maximum(largest, own.load / (mass * own.layers));
        int supports = 0;
        for_each_support(stores, own.body, up, [&](const Contact&, std::uint32_t) { supports++; });
        for_each_support(stores, own.body, up, [&](const Contact&, std::uint32_t below) {
            Loaded* other = find(below);
            if (other == nullptr || other->height >= own.height) return;
            other->load += (own.load + mass) / supports;
            other->layers = std::max(other->layers, own.layers + 1);
        });
    }
    return largest;
}

bool may_be_solved_directly(const ContactGraph& stores, std::span<const std::uint32_t> islands) {
    std::uint32_t bodies = 0, manifolds = 0;
    for (const std::uint32_t island : islands) bodies += stores.islands.islands[island].bodies;
    if (stores.def.planar || bodies > tuning::max_group_bodies) return false;
    const Vec3 up = -normalized(stores.def.gravity);
    bool suits = true;
    for_each_body(stores, islands, [&](std::uint32_t body) {
        const BodyCold& cold = stores.bodies.cold[body];
        suits = suits && cold.first_joint == none && !cold.asleep_in_place;
        manifolds += cold.constraints;  // those of two dynamic bodies twice
    });
    if (!suits || manifolds > tuning::max_group_manifolds) return false;
    for_each_body(stores, islands, [&](std::uint32_t body) {
        for_each_manifold(stores.contacts, stores.bodies.cold[body], [&](std::uint32_t index) {
            const Contact& c = stores.contacts.contacts[index];
            const double rise = dot(normal_of(lane_ref_of(stores.graph, c)), up);
            suits = suits && (!c.touching || absolute(rise) >= tuning::lies_on);
        });
    });
    return suits;
}

bool mostly_stand(const ContactGraph& stores, std::span<const std::uint32_t> islands) {
    std::uint32_t bodies = 0, moving = 0;
    Vec3 mean;
    for_each_body(stores, islands, [&](std::uint32_t body) {
        mean = mean + warm_of(stores, body).v;
        bodies++;
    });
    mean = mean * (1.0 / bodies);
    const double gravity = gravity_ratio_squared(stores.def.gravity);
    bool tumbles = false;
    for_each_body(stores, islands, [&](std::uint32_t body) {
        const BodyWarm& warm = warm_of(stores, body);
        const double radius = stores.bodies.cold[body].radius, scale = speed_scale(radius, gravity),
                     speed = length(warm.v - mean) + length(warm.w) * radius;
        if (speed > tuning::standing_speed * scale) moving++;
        tumbles = tumbles || speed > tuning::tumbling_speed * scale;
    });
    return !tumbles && moving <= std::max(2u, bodies / 4);
}

void raise_to_heavy_tier(ContactGraph& stores, JointStore& joints,
                         std::span<const std::uint32_t> bodies) {
    if (stores.def.gravity == Vec3{}) return;
    const Vec3 up = -normalized(stores.def.gravity);
    for (const std::uint32_t body : bodies) {
        const std::uint32_t island = stores.bodies.cold[body].island;
        const ColourSetKey set = stores.islands.islands[island].colour_set;
        if (set.tier >= SolverTier::heavy || !is_heavy_load(stores, body, up)) continue;
        move_to_set(stores, joints, coupled_islands(stores, stores.contacts, island),
                    {SolverTier::heavy, set.batch});
    }
}

void raise_to_direct_tier(ContactGraph& stores, JointStore& joints,
                          std::span<const std::uint32_t> bodies) {
    if (stores.def.gravity == Vec3{}) return;
    const Vec3 up = -normalized(stores.def.gravity);
    for (const std::uint32_t body : bodies) {
        const std::uint32_t island = stores.bodies.cold[body].island;
        const ColourSetKey set = stores.islands.islands[island].colour_set;
        if (set.tier == SolverTier::direct ||
            stores.islands.islands[island].bodies > tuning::max_group_bodies)
            continue;
        const std::vector<std::uint32_t> coupled =
            few_coupled_islands(stores, stores.contacts, island, tuning::max_group_bodies);
        if (!coupled.empty() && may_be_solved_directly(stores, coupled) &&
            mostly_stand(stores, coupled) &&
            largest_load_ratio(stores, coupled, up) >= tuning::direct_load_ratio)
            move_to_set(stores, joints, coupled, {SolverTier::direct, set.batch});
    }
}

void leave_direct_tier(ContactGraph& stores, JointStore& joints) {
    const auto first = stores.graph.sets.begin() +
                       static_cast<std::ptrdiff_t>(index_of(ColourSetKey{SolverTier::direct, 0}));
    if (std::all_of(first, first + batch_count,
                    [](const ColourSet& set) { return set.contacts == 0; }))
        return;
    std::vector<std::uint32_t> awake;
    find_awake_islands(stores, awake);
    for (const std::uint32_t island : awake) {
        const ColourSetKey set = stores.islands.islands[island].colour_set;
        if (set.tier != SolverTier::direct) continue;
        const std::vector<std::uint32_t> coupled = coupled_islands(stores, stores.contacts, island);
        if (!may_be_solved_directly(stores, coupled) || !mostly_stand(stores, coupled))
            move_to_set(stores, joints, coupled, {SolverTier::heavy, set.batch});
    }
}

void leave_direct_tier(ContactGraph& stores, JointStore& joints,
                       std::span<const std::uint32_t> bodies) {
    for (const std::uint32_t body : bodies) {
        const std::uint32_t island = stores.bodies.cold[body].island;
        const ColourSetKey set = stores.islands.islands[island].colour_set;
        if (set.tier == SolverTier::direct)
            move_to_set(stores, joints, coupled_islands(stores, stores.contacts, island),
                        {SolverTier::heavy, set.batch});
    }
}

}  // namespace jostle::physics
