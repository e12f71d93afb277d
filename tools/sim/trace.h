// SPDX-License-Identifier: MIT
//
// Writes a run as CSV: one row per dynamic or kinematic body and tick. Columns: tick, body (index
// in the scene, from 0), name, px py pz (m), qx qy qz qw, vx vy vz (m/s), wx wy wz (rad/s). Tick 0
// is the start.
#pragma once

#include <cstdio>
#include <memory>
#include <string>

#include "jostle/scenes/scene.h"

namespace jostle::sim {

class Trace {
public:
    // Returns null if the file cannot be written.
    static std::unique_ptr<Trace> open(const std::string& path);
    ~Trace();

    void write(std::uint64_t tick, const scenes::BuiltScene& scene,
               const scenes::SceneDescription& description);
    // Closes the file. Returns false if not everything was written.
    bool close();

private:
    explicit Trace(std::FILE* file) : file_(file) {}
    std::FILE* file_;
};

}  // namespace jostle::sim
