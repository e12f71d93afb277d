// SPDX-License-Identifier: MIT
//
// Which pairs are swept, and who resolves their impacts. Two stages must agree on both. What
// update_contacts foresees, the contact solver resolves; all else solve_continuous does. Both read
// ContactScratch::had_contacts, which select_pairs leaves.
#pragma once

#include "physics/src/foundation/tuning.h"
#include "physics/src/stages/step_context.h"
#include "physics/src/stages/step_scratch.h"
#include "physics/src/state/combine.h"

namespace jostle::physics {

// Whether a body had contacts in the constraint graph when the step began.
inline bool had_contacts(const ContactScratch& scratch, const BodyCold& cold) {
    const auto& held = scratch.had_contacts;
    return cold.set == BodySet::sleeping || (cold.at < held.size() && held[cold.at] != 0);
}

// Whether strain leaves the impacts of two bodies on each other to the contact solver, however
// fast.
inline bool left_to_contacts(const WorldState& world, const BodyCold& a, const BodyCold& b) {
    return leaves_impacts_to_contacts(world.overload_level) && a.type == BodyType::dynamic &&
           b.type == BodyType::dynamic;
}

// How far a body may move against another in a step without a sweep, m. In a crowd, where one of
// the two already leans on others, their inner radii count together: impacts there come in chains,
// which the contact solver resolves all at once and sweeps only one after the other.
inline double motion_without_sweep(const ContactScratch& scratch, const BodyCold& mover,
                                   const BodyCold& other) {
    double size = mover.inner_radius;
    if (other.type == BodyType::dynamic &&
        (had_contacts(scratch, mover) || had_contacts(scratch, other)))
        size += other.inner_radius;
    return tuning::sweep_fraction * size;
}

// Whether two shapes bounce off each other at the moment when they meet, which the sweep alone
// finds: it sweeps them however little they move. What a bounce gives back, and in which direction,
// depends on that moment; the contact solver knows nothing finer than its step. What hangs on
// joints is the solver's all the same: see below.
inline bool bounces(const WorldState& world, std::uint32_t shape_a, std::uint32_t shape_b) {
    const ShapeRecord &sa = world.shapes.shapes[shape_a], &sb = world.shapes.shapes[shape_b];
    if (sa.material.restitution == 0 && sb.material.restitution == 0) return false;  // mostly
    if (!world.def.continuous || !(pair_restitution(sa.material, sb.material) > 0)) return false;
    const BodyCold &a = world.bodies.cold[sa.body], &b = world.bodies.cold[sb.body];
    const auto sweeps = [](const BodyCold& cold) {
        return cold.type == BodyType::dynamic && cold.continuous;
    };
    if (left_to_contacts(world, a, b)) return false;
    return (sweeps(a) || sweeps(b)) && a.first_joint == none && b.first_joint == none;
}

// Whether the contact solver resolves the impact of two shapes that are swept, along with what
// holds their bodies. A sweep would let them go on without that: what hangs on joints would leave
// them, and what leans on others would hit them in turn. Of bodies without joints it resolves only
// what does not bounce: what bounces has the rest of the step to go back, which the solver does not
// give it.
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
