// SPDX-License-Identifier: MIT
//
// The interface of an engine in the accuracy benchmark. One file per engine:
// jostle_accuracy_engine, bullet_accuracy_engine and so on. An engine is built once, for one scene
// in one mode, and used by one thread.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bench/accuracy/accuracy_scene.h"
#include "jostle/base/result.h"

namespace jostle::bench::accuracy {

// State of the centre of mass and the principal axes; velocity and spin in world axes.
struct BodyState {
    Vec3 position;
    Quat rotation;
    Vec3 velocity, spin;
};

// Entries and exits of triggers, since the start.
struct TriggerCounts {
    int entered = 0, left = 0;
};

class Engine {
public:
    virtual ~Engine() = default;

    // Builds the scene; called once, before all other functions. Returns an error if the engine
    // does not support a feature of the scene; the row is then omitted. Bodies never sleep, and
    // Scene::damping is the only damping.
    virtual Status build(const Scene& scene, const std::string& mode) = 0;
    // Steps by dt seconds, with the forces of Scene::central_pull and mutual_pull. Only this call
    // is timed.
    virtual void step(double dt) = 0;
    virtual BodyState state(int body) const = 0;             // undefined for fixed bodies
    virtual void set_damping(double rate) = 0;               // 1/s, of all bodies
    virtual void set_velocity(int body, Vec3 velocity) = 0;  // of a driven body
    // An error that the engine has reported since the start, which invalidates the run. Empty:
    // none.
    virtual std::string failure() const { return {}; }
    virtual TriggerCounts trigger_counts() const { return {}; }
};

struct EngineKind {
    const char* name;
    const char* about;                  // for --help: precision and meaning of the modes
    std::vector<std::string> modes;     // the default mode first
    std::unique_ptr<Engine> (*make)();  // null: not included in this build
};

}  // namespace jostle::bench::accuracy
