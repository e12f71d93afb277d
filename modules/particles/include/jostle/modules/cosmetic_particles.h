// SPDX-License-Identifier: MIT
//
// Cosmetic particles on a client: simulated from the definitions that the channel
// "particles.cosmetic" carries once, so they cost no bytes per tick. All clients compute the same
// particles, no matter when they connect: emission and motion depend only on the definition and on
// a fixed grid of time steps that starts at time 0 of the world.
//
//     CosmeticParticles smoke;
//     smoke.decode(view.channel("particles.cosmetic", 0)).expect();
//     smoke.advance_to(rendered_time);
//     for (const ParticleGroup& group : smoke.groups()) draw(group.positions(), group.def());
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "jostle/modules/particle_group.h"

namespace jostle::modules {

/// Time step of cosmetic particles, s.
inline constexpr double cosmetic_step = 1.0 / 60;
/// Version of the encoding, the first of its values.
inline constexpr std::int32_t cosmetic_version = 1;

/// Encodes gravity (m/s^2) and definitions of groups as the values of a channel.
///
/// The values are: cosmetic_version, the number of bytes that follow, and the bytes, four per value
/// with the lowest first. The bytes are little-endian numbers: gravity (3 doubles), the number of
/// definitions (64 bits), then each definition in the order of particle_fields.h.
std::vector<std::int32_t> encode_cosmetic(physics::Vec3 gravity,
                                          std::span<const ParticleGroupDef* const> defs);

/// Simulates cosmetic groups. Not thread-safe.
class CosmeticParticles {
public:
    /// Replaces the groups by those of encoded values, which may come from an untrusted source. If
    /// the values are those of the last call, nothing changes. Returns corrupt_data, naming the
    /// field; the groups are then unchanged.
    physics::Status decode(std::span<const std::int32_t> values);
    /// Simulates until world time `time` (s). A jump back, or by more than the longest lifetime,
    /// restarts the simulation one lifetime before that time.
    void advance_to(double time);
    std::span<const ParticleGroup> groups() const { return groups_; }

private:
    std::vector<std::int32_t> values_;
    physics::Vec3 gravity_ = {};
    std::vector<ParticleGroup> groups_;
    std::int64_t step_ = 0;  ///< number of the next step on the grid
};

}  // namespace jostle::modules
