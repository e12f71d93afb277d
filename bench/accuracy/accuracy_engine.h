// SPDX-License-Identifier: MIT
//
// What the laboratory asks of an engine. One file each: jostle_lab_engine, bullet_lab_engine and so
// on. An engine is built once, for one scene in one mode, and used by one thread.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bench/accuracy/accuracy_scene.h"
#include "jostle/base/result.h"

namespace jostle::bench::accuracy {

// Of the centre of mass and the principal axes; velocity and spin in world axes.
struct BodyState {
    Vec3 position;
    Quat rotation;
    Vec3 velocity, spin;
};

class Engine {
public:
    virtual ~Engine() = default;

    // Once, before all else. An error says what the scene has and the engine lacks; the row is left
    // out then. Bodies never sleep, and nothing slows them down but Scene::damping.
    virtual Status build(const Scene& scene, const std::string& mode) = 0;
    // By dt seconds, with the forces of Scene::central_pull and mutual_pull. This alone is timed.
    virtual void step(double dt) = 0;
    virtual BodyState state(int body) const = 0;             // of a fixed body nothing is said
    virtual void set_damping(double rate) = 0;               // 1/s, of all bodies
    virtual void set_velocity(int body, Vec3 velocity) = 0;  // of a driven body
    // What the engine complained about since the start: the run is worth nothing. Empty: nothing.
    virtual std::string failure() const { return {}; }
};

struct EngineKind {
    const char* name;
    const char* about;                  // for --help: precision and what its modes mean
    std::vector<std::string> modes;     // the default one first
    std::unique_ptr<Engine> (*make)();  // null when this build was made without it
};

}  // namespace jostle::bench::accuracy
