// SPDX-License-Identifier: MIT
//
// Decides which pairs are swept and which stage resolves their impacts. Two stages must agree on
// both. Impacts that update_contacts predicts are resolved by the contact solver, all others by
// solve_continuous. Both stages read ContactScratch::had_contacts, which select_pairs writes.
#pragma once

#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/step_context.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/pair_properties.h"

namespace jostle::physics {

// Returns whether a body had contacts in the constraint graph at the start of the step.
inline bool had_contacts(const ContactScratch& scratch, const BodyCold& cold) {
    const auto& held = scratch.had_contacts;
    return cold.set == BodySet::sleeping || (cold.at < held.size() && held[cold.at] != 0);
}

// Returns whether this step has had more sweeps after impacts than a crowd of flying bodies needs.
// Where dozens of bodies overlap, each impact changes the candidates of all others, and the sweeps
// would not end. `bouncing`: whether bodies may bounce, which needs the time of the impact.
inline bool exceeds_sweeps(const WorldState& world, bool bouncing) {
    const int least = bouncing ? tuning::min_bounce_sweep_limit : tuning::min_sweep_limit,
              per_body = bouncing ? tuning::bounce_sweeps_per_body : tuning::sweeps_per_body;
    return world.profile.sweeps_after_impacts >
           least + per_body * static_cast<int>(world.bodies.awake.size());
}

// Returns whether the overload level or the number of sweeps leaves impacts between two dynamic
// bodies to the contact solver, regardless of their speed.
inline bool left_to_contacts(const WorldState& world, const BodyCold& a, const BodyCold& b,
                             bool bouncing) {
    return a.type == BodyType::dynamic && b.type == BodyType::dynamic &&
           (leaves_impacts_to_contacts(world.overload_level) || exceeds_sweeps(world, bouncing));
}

// The relative displacement in a step that needs no sweep, m. Two dynamic bodies are swept only if
// the balls of their inner radii could come halfway through each other: predicted contacts resolve
// slower impacts, and in piles, where impacts come in chains, they resolve them together.
inline double motion_without_sweep(const BodyCold& mover, const BodyCold& other) {
    const double size = other.type == BodyType::dynamic ? mover.inner_radius + other.inner_radius
                                                        : mover.inner_radius;
    return tuning::sweep_fraction * size;
}

// Returns whether two shapes bounce at the time of contact, which only the sweep finds. Such pairs
// are swept regardless of their displacement. The rebound speed and its direction depend on the
// time of contact, which the contact solver cannot resolve within a step. Bodies with joints are
// still handled by the solver: see below.
inline bool bounces(const WorldState& world, std::uint32_t shape_a, std::uint32_t shape_b) {
    const ShapeRecord &sa = world.shapes.shapes[shape_a], &sb = world.shapes.shapes[shape_b];
    if (sa.material.restitution == 0 && sb.material.restitution == 0) return false;  // usual case
    if (!world.def.continuous || !(pair_restitution(sa.material, sb.material) > 0)) return false;
    const BodyCold &a = world.bodies.cold[sa.body], &b = world.bodies.cold[sb.body];
    const auto sweeps = [](const BodyCold& cold) {
        return cold.type == BodyType::dynamic && cold.continuous;
    };
    if (left_to_contacts(world, a, b, true)) return false;
    return (sweeps(a) || sweeps(b)) && a.first_joint == none && b.first_joint == none;
}

// Returns whether the contact solver resolves the impact of two swept shapes, together with the
// constraints of their bodies. A sweep would move the bodies without these constraints: a jointed
// body would be torn from its neighbours, and a supported body would in turn hit its supports.
// Without joints the solver handles only impacts that do not bounce, because a bouncing body moves
// back within the rest of the step, which the solver does not model.
inline bool uses_speculative_contact(const StepContext& step, std::uint32_t shape_a,
                                     std::uint32_t shape_b) {
    const WorldState& world = step.world;
    const ShapeRecord &sa = world.shapes.shapes[shape_a], &sb = world.shapes.shapes[shape_b];
    const BodyCold &a = world.bodies.cold[sa.body], &b = world.bodies.cold[sb.body];
    if (a.first_joint != none || b.first_joint != none) return true;
    const auto leans = [&](const BodyCold& cold) {
        return cold.type == BodyType::dynamic && had_contacts(step.scratch.contacts, cold);
    };
    return (leans(a) || leans(b)) && pair_restitution(sa.material, sb.material) == 0;
}

}  // namespace jostle::physics
