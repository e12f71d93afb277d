// SPDX-License-Identifier: MIT
//
// The particles that an emitter creates within an interval. Stateless: the number of a particle
// determines when and how it starts.
#pragma once

#include <cstdint>

#include "jostle/modules/emitter.h"

namespace jostle::modules::particles_detail {

struct EmittedParticle {
    physics::Vec3 position, velocity;
    double time;      // s, of emission
    double lifetime;  // s
    std::uint32_t id;
};

// Numbers [first, last) of one of the two streams of an emitter.
struct EmittedRange {
    std::uint64_t first = 0, last = 0;
};

// The particles that start in [from, to), s. Consecutive intervals contain each particle once.
// Limited to the last `most` ones.
EmittedRange emitted_at_rate(const Emitter& emitter, double from, double to, std::uint64_t most);
EmittedRange emitted_in_bursts(const Emitter& emitter, double from, double to, std::uint64_t most);

EmittedParticle particle_at_rate(const Emitter& emitter, std::uint64_t number, bool planar);
EmittedParticle particle_of_burst(const Emitter& emitter, std::uint64_t number, bool planar);

}  // namespace jostle::modules::particles_detail
