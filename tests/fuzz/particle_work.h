// SPDX-License-Identifier: MIT
//
// Worlds with many particles take long but make no better input than those with a few.
#pragma once

#include "jostle/modules/particles.h"
#include "jostle/physics/world.h"

namespace jostle::fuzz {

inline bool has_many_particles(const physics::World& world) {
    constexpr double work_max = 20000;  // a few milliseconds a step, without the sanitizers
    const auto* particles = dynamic_cast<const modules::Particles*>(world.module("particles"));
    return particles != nullptr && particles->work() > work_max;
}

}  // namespace jostle::fuzz
