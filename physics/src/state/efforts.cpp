// SPDX-License-Identifier: MIT
#include "state/efforts.h"

#include <cstddef>

#include "foundation/check.h"
#include "state/lanes.h"

namespace jostle::physics {
namespace {

template <class Visit>
void for_each_body(const WorldState& world, std::uint32_t island, Visit&& visit) {
    for (std::uint32_t body = world.islands.islands[island].first; body != none;
         body = world.bodies.cold[body].island_next)
        visit(body);
}

// By the ratio of the sub-steps' lengths. Stiffness goes with the inverse square of that: what a
// contact gives beyond its steady impulse would jump with it, so the steady impulse makes up for
// the difference and the load stays what it is. `even`: the points of a manifold share it.
void scale_impulses(SavedManifold& saved, float scale, bool even) {
    const auto row = [&](std::size_t offset, std::size_t k = 0) -> float& {
        constexpr std::size_t first_saved_row = 2;
        return saved.rows[offset / 32 + k - first_saved_row];
    };
    float lambda_sum = 0, steady_sum = 0, points = 0;
    for (std::size_t k = 0; k < 4; k++) {
        if (row(offsetof(ManifoldBlock, gap), k) > 0.5f * no_point) continue;
        lambda_sum += row(offsetof(ManifoldBlock, lambda), k) *= scale;
        steady_sum += row(offsetof(ManifoldBlock, steady), k) *= scale;
        points++;
    }
    for (std::size_t k = 0; k < 2; k++) row(offsetof(ManifoldBlock, friction), k) *= scale;
    row(offsetof(ManifoldBlock, twist)) *= scale;
    const float stiffer = 1 / (scale * scale);
    for (std::size_t k = 0; k < 4; k++) {
        float& steady = row(offsetof(ManifoldBlock, steady), k);
        const float lambda = even ? lambda_sum / points : row(offsetof(ManifoldBlock, lambda), k);
        const float before = even ? steady_sum / points : steady;
        steady = lambda - stiffer * (lambda - before);
    }
    constexpr std::size_t roll = offsetof(BlockRough, roll) / 32;
    saved.rough_values[roll] *= scale;
    saved.rough_values[roll + 1] *= scale;
}

void scale_impulses(Joint& joint, double scale) {
    for (Vec3* v : {&joint.point, &joint.turn, &joint.drive}) *v = *v * scale;
    for (double* x : {&joint.lower, &joint.upper, &joint.swing, &joint.spring, &joint.motor})
        *x *= scale;
}

void move_lanes(WorldState& world, std::uint32_t body, float scale, bool even) {
    for_each_contact(world.contacts, world.bodies.cold[body], [&](std::uint32_t index) {
        Contact& c = world.contacts.contacts[index];
        if (c.colour < 0 || c.body_a != body) return;
        SavedManifold saved = save_lane(world, index);
        release_lane(world, index);
        scale_impulses(saved, scale, even);
        restore_lane(world, saved);
    });
}

void scale_joints(WorldState& world, std::uint32_t body, double scale) {
    for_each_joint(world.joints, world.bodies.cold[body], [&](std::uint32_t index) {
        Joint& j = world.joints.joints[index];
        // Once each: at its first dynamic body.
        const bool first = world.bodies.cold[j.body_a].type == BodyType::dynamic;
        if ((first ? j.body_a : j.body_b) == body) scale_impulses(j, scale);
    });
}

void scale_lane(const LanePlace& place, float scale) {
    const auto row = [&](float* values) { values[place.lane] *= scale; };
    for (auto& lambda : place.block->lambda) row(lambda);
    for (auto& friction : place.block->friction) row(friction);
    row(place.block->twist);
    for (auto& steady : place.block->steady) row(steady);
    for (auto& roll : place.rough->roll) row(roll);
}

}  // namespace

std::vector<std::uint32_t> tied_islands(const WorldState& world, std::uint32_t island) {
    std::vector<std::uint32_t> tied{island};
    std::vector<bool> seen(world.islands.islands.size(), false);
    seen[island] = true;
    for (std::size_t k = 0; k < tied.size(); k++)
        for_each_body(world, tied[k], [&](std::uint32_t body) {
            const BodyCold& cold = world.bodies.cold[body];
            if (cold.lanes == 0) return;
            for_each_contact(world.contacts, cold, [&](std::uint32_t index) {
                const Contact& c = world.contacts.contacts[index];
                if (c.colour < 0) return;
                const std::uint32_t other =
                    world.bodies.cold[c.body_a == body ? c.body_b : c.body_a].island;
                if (other == none || seen[other]) return;
                seen[other] = true;
                tied.push_back(other);
            });
        });
    return tied;
}

void set_effort(WorldState& world, const std::vector<std::uint32_t>& islands, Effort effort) {
    const Effort before = world.islands.islands[islands.front()].effort;
    if (before == effort) return;
    const double scale = static_cast<double>(substeps_of(before, world.def.substeps)) /
                         substeps_of(effort, world.def.substeps);
    // All islands first: lanes ask what effort their bodies have.
    for (const std::uint32_t i : islands) {
        ASSERT(world.islands.islands[i].effort == before && !world.islands.islands[i].asleep);
        world.islands.islands[i].effort = effort;
        world.islands.islands[i].calm = 0;
    }
    for (const std::uint32_t i : islands)
        for_each_body(world, i, [&](std::uint32_t body) {
            move_lanes(world, body, static_cast<float>(scale), effort > Effort::low);
            scale_joints(world, body, scale);
        });
}

void scale_loads(WorldState& world, const Island& island, float scale) {
    for (std::uint32_t body = island.first; body != none;
         body = world.bodies.cold[body].island_next)
        for_each_contact(world.contacts, world.bodies.cold[body], [&](std::uint32_t index) {
            const Contact& c = world.contacts.contacts[index];
            if (c.colour >= 0 && c.body_a == body) scale_lane(place_of(world, c), scale);
        });
}

void level_efforts(WorldState& world, std::uint32_t a, std::uint32_t b) {
    const Island &ia = world.islands.islands[a], &ib = world.islands.islands[b];
    if (ia.effort == ib.effort) return;
    // What touches a heap does not make it slender, nor the other way round.
    const int substeps = world.def.substeps;
    const bool alike = substeps_of(ia.effort, substeps) == substeps_of(ib.effort, substeps);
    const bool a_yields = alike ? ia.bodies < ib.bodies : ia.effort < ib.effort;
    if (a_yields)
        set_effort(world, tied_islands(world, a), ib.effort);
    else
        set_effort(world, tied_islands(world, b), ia.effort);
}

}  // namespace jostle::physics
