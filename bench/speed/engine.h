// SPDX-License-Identifier: MIT
//
// What is asked of an engine under test, and the engines there are. One file each: jostle_engine,
// bullet_engine, ode_engine. Bodies are named by their index in the scene.
#pragma once

#include <memory>
#include <span>
#include <string_view>

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
    virtual int awake() const = 0;  // bodies that can move and do not sleep
};

struct EngineKind {
    const char* name;
    const char* settings;               // what differs from its defaults, for --help
    int most_threads;                   // 1 when there is nothing to gain from more
    std::unique_ptr<Engine> (*make)();  // null when this build was made without it
};

// Jostle first, then its peers.
std::span<const EngineKind> engine_kinds();

// Null when there is no such engine.
const EngineKind* find_engine_kind(std::string_view name);

}  // namespace jostle::bench
