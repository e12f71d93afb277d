// SPDX-License-Identifier: MIT
//
// What the laboratory asks of an engine. One file each: jostle_engine, bullet_engine, ode_engine.
// Bodies are named by their index in the scene.
#pragma once

#include <cstdint>

#include "jostle/physics/result.h"
#include "speed/scene_description.h"

namespace jostle::bench {

class Engine {
public:
    virtual ~Engine() = default;

    // Once, before all else. The scene must outlive the engine.
    virtual physics::Status init(const SceneDescription& scene, int threads, bool sleep) = 0;
    virtual void step() = 0;  // by step_seconds
    virtual physics::Transform pose(std::uint32_t body) const = 0;
    virtual physics::Vec3 velocity(std::uint32_t body) const = 0;             // linear
    virtual void set_velocity(std::uint32_t body, physics::Vec3 linear) = 0;  // spin stays; wakes
    virtual int awake() const = 0;  // bodies that can move and do not sleep
};

}  // namespace jostle::bench
