// SPDX-License-Identifier: MIT
//
// The interface of an engine under test. One file each: jostle_engine, bullet_engine, ode_engine.
// Bodies are identified by their index in the scene.
#pragma once

#include <cstdint>

#include "jostle/physics/result.h"
#include "jostle/scenes/scene.h"

namespace jostle::bench {

class Engine {
public:
    virtual ~Engine() = default;

    // Called once, before all other functions. Threads and sleeping follow the scene's world. The
    // scene must outlive the engine.
    virtual physics::Status init(const scenes::SceneDescription& scene) = 0;
    virtual void step() = 0;  // by 1 / hz of the scene
    virtual physics::Transform pose(std::uint32_t body) const = 0;
    virtual physics::Vec3 velocity(std::uint32_t body) const = 0;  // linear
    // keeps the spin; wakes the body
    virtual void set_velocity(std::uint32_t body, physics::Vec3 linear) = 0;
    // The most expensive stage of the last step; null if the engine does not report it.
    virtual const char* worst_stage() const { return nullptr; }
    virtual int awake() const = 0;  // number of movable bodies that are awake
};

}  // namespace jostle::bench
