// SPDX-License-Identifier: MIT
//
// Jostle behind the laboratory's interface.
#pragma once

#include <memory>

#include "jostle/physics/world.h"
#include "speed/engine.h"

namespace jostle::bench {

std::unique_ptr<Engine> make_jostle_engine();

physics::Result<physics::BodyId> add_body(physics::World& world, const SceneBody& body);

}  // namespace jostle::bench
