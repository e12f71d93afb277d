// SPDX-License-Identifier: MIT
//
// What is asked of an engine under test. One file each: jostle_engine, bullet_engine, ode_engine.
// Bodies are named by their index in the scene.
#pragma once

#include <cstdint>

#include "jostle/physics/result.h"
#include "jostle/scenes/scene.h"

namespace jostle::bench {

class Engine {
public:
    virtual ~Engine() = default;

    // Once, before all else: threads and sleep as the scene's world says. The scene must outlive
    // the engine.
    virtual physics::Status init(const scenes::SceneDescription& scene) = 0;
    virtual void step() = 0;  // by 1 / hz of the scene
    virtual physics::Transform pose(std::uint32_t body) const = 0;
    virtual physics::Vec3 velocity(std::uint32_t body) const = 0;             // linear
    virtual void set_velocity(std::uint32_t body, physics::Vec3 linear) = 0;  // spin stays; wakes
    // The stage that took most of the last step; null of an engine that does not say.
    virtual const char* worst_stage() const { return nullptr; }
    virtual int awake() const = 0;  // bodies that can move and do not sleep
};

}  // namespace jostle::bench
