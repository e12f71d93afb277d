// SPDX-License-Identifier: MIT
//
// Memory that a group reuses between steps. None of it is state.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "jostle/physics/mat3.h"
#include "jostle/physics/world.h"

namespace jostle::modules::particles_detail {

// A pair of particles, by index.
struct ParticlePair {
    std::uint32_t a, b;
};

// A spring in the matrix of implicit Euler: coefficients along its direction n and across it.
struct SpringBlock {
    physics::Vec3 n;
    double along, across;
};

// A surface of a fixed or kinematic body that a particle touched in this substep. The centre of the
// particle stays where dot(normal, p) >= offset; `speed` is that of the surface along the normal.
// A normal of 0: none.
struct ParticleSupport {
    physics::Vec3 normal;
    double offset = 0, speed = 0;
};

struct ParticleScratch {
    // Positions at the start of a substep, and the mean accelerations in it.
    std::vector<physics::Vec3> before_position, mean_acceleration;
    // Integration: states of stages, accelerations, and weighted sums over stages.
    std::vector<physics::Vec3> start_velocity, stage_position, stage_velocity;
    std::vector<physics::Vec3> acceleration, position_rate, velocity_rate;
    // Implicit Euler: residual, correction and vectors of the conjugate gradients, inverse blocks.
    std::vector<physics::Vec3> residual, correction, direction, product;
    std::vector<physics::Mat3> block, inverse_block;
    std::vector<SpringBlock> spring_block;
    // Contacts: particles sorted by cell, first particle of each bucket, pairs.
    std::vector<std::uint32_t> bucket, first_of_bucket, sorted, pair_count, new_index;
    std::vector<ParticlePair> pairs;
    std::vector<ParticleSupport> supports;  // per particle; empty without bodies
    std::vector<ParticleSupport> planes;    // of the group
};

// Calls function(first, last) on the threads of a world, or once if there is no world.
inline void for_ranges(const physics::World* world, std::size_t count, int grain,
                       const std::function<void(int, int)>& function) {
    if (world != nullptr)
        world->parallel_for(static_cast<int>(count), grain, function);
    else if (count > 0)
        function(0, static_cast<int>(count));
}

}  // namespace jostle::modules::particles_detail
