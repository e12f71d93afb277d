// SPDX-License-Identifier: MIT
//
// Groups and worlds with particles, in one line.
#pragma once

#include "jostle/modules/particles.h"
#include "tests/support/world_builder.h"

namespace jostle::modules {

using namespace physics;

// A group without emitter, and its particles.
inline ParticleGroup group_of(const ParticleGroupDef& def,
                              const std::vector<ParticleStart>& particles) {
    ParticleGroup group = test::must(ParticleGroup::create(def));
    test::must(group.add(particles));
    return group;
}

// Advances a group without a world for `steps` steps of h seconds.
inline void advance(ParticleGroup& group, int steps, double h, Vec3 gravity = {}) {
    for (int k = 0; k < steps; k++) group.advance({.gravity = gravity}, k * h, (k + 1) * h);
}

inline Particles& particles_of(World& world) {
    register_particles();
    if (world.module("particles") == nullptr)
        test::must(world.add_module(std::make_unique<Particles>()));
    return *dynamic_cast<Particles*>(world.module("particles"));
}

inline ParticleGroup& add_group(World& world, const ParticleGroupDef& def,
                                const std::vector<ParticleStart>& particles = {}) {
    Particles& module = particles_of(world);
    ParticleGroup& group = *module.group(test::must(module.add(world, def)));
    test::must(group.add(particles));
    return group;
}

}  // namespace jostle::modules
