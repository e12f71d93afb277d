// SPDX-License-Identifier: MIT
#include "physics/src/stages/islands/island_stages.h"

#include "physics/src/foundation/tuning.h"
#include "physics/src/state/contact_constraints.h"
#include "physics/src/state/island_tiers.h"

namespace jostle::physics {
namespace {

// Returns whether the body rests only on bodies that are a hundred times lighter.
bool is_heavy_load(ContactGraph& stores, std::uint32_t body, Vec3 up) {
    const double most = stores.bodies.cold[body].mass / tuning::heavy_ratio;
    bool on_light = false, on_firm = false;
    for_each_manifold(stores.contacts, stores.bodies.cold[body], [&](std::uint32_t index) {
        const Contact& c = stores.contacts.contacts[index];
        if (!c.touching) return;
        const double rise = dot(normal_of(lane_ref_of(stores.graph, c)), up);
        // The normal points from a to b.
        if ((c.body_a == body ? -rise : rise) < tuning::lies_on) return;
        const BodyCold& other = stores.bodies.cold[c.body_a == body ? c.body_b : c.body_a];
        if (other.type == BodyType::dynamic && other.mass <= most)
            on_light = true;
        else
            on_firm = true;
    });
    return on_light && !on_firm;
}

}  // namespace

bool has_heavy_load(ContactGraph& stores, const Island& island, Vec3 up) {
    for (std::uint32_t body = island.first; body != none;
         body = stores.bodies.cold[body].island_next)
        if (is_heavy_load(stores, body, up)) return true;
    return false;
}

void raise_to_heavy_tier(ContactGraph& stores, JointStore& joints,
                         std::span<const std::uint32_t> bodies) {
    if (stores.def.gravity == Vec3{}) return;
    const Vec3 up = -normalized(stores.def.gravity);
    for (const std::uint32_t body : bodies) {
        const std::uint32_t island = stores.bodies.cold[body].island;
        const ColourSetKey set = stores.islands.islands[island].colour_set;
        if (set.tier == SolverTier::heavy || !is_heavy_load(stores, body, up)) continue;
        move_to_set(stores, joints, coupled_islands(stores, stores.contacts, island),
                    {SolverTier::heavy, set.batch});
    }
}

}  // namespace jostle::physics
