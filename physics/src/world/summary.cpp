// SPDX-License-Identifier: MIT
#include "jostle/physics/world.h"
#include "physics/src/constraint_graph/joint_memory.h"
#include "physics/src/constraints/joints/axes_layout.h"
#include "physics/src/state/world_state.h"

namespace jostle::physics {
namespace {

double deepest(const ConstraintGraph& graph, const IslandStore& islands) {
    float gap = 0;
    for_each_colour(graph.sets, [&](const GraphColour& colour) {
        for (const ContactConstraintWide& block : colour.blocks)
            for (const auto& row : block.gap)
                for (const float g : row) gap = g < gap ? g : gap;
    });
    constexpr std::size_t first_gap = offsetof(ContactConstraintWide, gap) / 32 - 2;
    for (const Island& island : islands.islands)
        for (const SavedContact& saved : island.manifolds)
            for (std::size_t i = 0; i < 4; i++)
                gap = saved.rows[first_gap + i] < gap ? saved.rows[first_gap + i] : gap;
    return -double{gap};
}

void add_body(WorldSummary& sum, Vec3 gravity, const BodyCold& cold, const BodyWarm& warm) {
    const Vec3 spin_momentum = warm.axes * (cold.inertia * transposed_times(warm.axes, warm.w));
    sum.kinetic_energy += 0.5 * (cold.mass * length_squared(warm.v) + dot(warm.w, spin_momentum));
    sum.potential_energy -= cold.mass * cold.gravity_scale * dot(gravity, warm.center);
    sum.linear_momentum += warm.v * cold.mass;
    sum.angular_momentum += spin_momentum + cross(warm.center, warm.v * cold.mass);
}

// Position error of a joint: distance of its ends from the allowed range, m.
double error_of(const JointState& j) {
    if (const auto* d = std::get_if<DistanceJoint>(&j.def.kind))
        return maximum(d->min_length - j.separation, j.separation - d->max_length);
    if (const auto* pulley = std::get_if<PulleyJoint>(&j.def.kind))
        return j.travel - pulley->length;
    if (std::holds_alternative<GrabJoint>(j.def.kind) || joint_is_geared(j.def.kind)) return 0;
    return std::visit(
        [&](const auto& kind) {
            if constexpr (requires { layout_of(kind); }) {
                const AxesLayout layout = layout_of(kind);
                return locked_error(layout, {inverse_rotate(layout.turn_a, j.offset), {}});
            } else {
                return j.separation;
            }
        },
        j.def.kind);
}

}  // namespace

WorldSummary World::summary() const {
    const WorldState& world = *state_;
    WorldSummary sum;
    sum.bodies = static_cast<int>(world.bodies.ids.alive_count());
    sum.shapes = static_cast<int>(world.shapes.ids.alive_count());
    sum.awake_bodies = static_cast<int>(world.bodies.awake.size() - world.bodies.asleep_in_place);
    for (std::uint32_t i = 0; i < world.bodies.ids.size(); i++) {
        if (!world.bodies.ids.alive(i) || world.bodies.cold[i].type != BodyType::dynamic) continue;
        sum.dynamic_bodies++;
        add_body(sum, world.def.gravity, world.bodies.cold[i], warm_of(world, i));
    }
    for (std::uint32_t i = 0; i < world.contacts.ids.size(); i++)
        if (world.contacts.ids.alive(i) && world.contacts.contacts[i].touching &&
            !world.contacts.contacts[i].composite)
            sum.contacts++;
    sum.max_penetration = deepest(world.graph, world.islands);
    for (const JointId id : joints()) {
        sum.joints++;
        const JointState j = *joint(id);
        sum.max_joint_error = maximum(sum.max_joint_error, error_of(j));
    }
    return sum;
}

}  // namespace jostle::physics
