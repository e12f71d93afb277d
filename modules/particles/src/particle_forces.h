// SPDX-License-Identifier: MIT
//
// Accelerations of the particles of a group, and their derivatives for implicit Euler.
#pragma once

#include <span>

#include "jostle/modules/particle_group.h"
#include "jostle/physics/mat3.h"

namespace jostle::modules::particles_detail {

struct ParticleForces {
    const ParticleGroupDef& def;
    const ParticleEnvironment& environment;
    std::span<const ParticleSpring> springs;

    // Velocity of the medium at a point.
    physics::Vec3 medium(physics::Vec3 position, double time) const;
    bool has_medium() const;

    // Writes the acceleration of each particle. Uses the threads of the world.
    void accelerate(std::span<const physics::Vec3> positions,
                    std::span<const physics::Vec3> velocities, double time,
                    std::span<physics::Vec3> accelerations) const;

    // Likewise without springs, but with the drag of the velocities that the particles reach `lead`
    // seconds later with their accelerations. The medium is evaluated once.
    void accelerate_after(std::span<const physics::Vec3> positions,
                          std::span<const physics::Vec3> velocities, double time, double lead,
                          std::span<physics::Vec3> accelerations) const;

    // Derivatives of the acceleration of one particle without springs, times h by its velocity plus
    // h^2 by its position. The motion of the medium, fields of the world and mutual attraction are
    // not included: Newton's method iterates over them.
    physics::Mat3 stiffness(physics::Vec3 position, physics::Vec3 velocity, double time,
                            double h) const;

private:
    physics::Vec3 position_acceleration(std::span<const physics::Vec3> positions,
                                        std::size_t k) const;
    physics::Vec3 drag_acceleration(physics::Vec3 u) const;
    physics::Vec3 world_acceleration(physics::Vec3 position) const;
    void add_springs(std::span<const physics::Vec3> positions,
                     std::span<const physics::Vec3> velocities,
                     std::span<physics::Vec3> accelerations) const;
    physics::Vec3 attraction_on(std::span<const physics::Vec3> positions, std::size_t k) const;
};

// A spring at its current ends: the direction from a to b, the length and the speed of lengthening.
struct SpringState {
    physics::Vec3 direction;
    double length, rate;

    SpringState(const ParticleSpring& spring, std::span<const physics::Vec3> positions,
                std::span<const physics::Vec3> velocities);
    // Force on a, N; b receives the opposite force.
    physics::Vec3 force(const ParticleSpring& spring) const;
};

}  // namespace jostle::modules::particles_detail
