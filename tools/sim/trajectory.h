// SPDX-License-Identifier: MIT
//
// Trajectories of the bodies of a scene, sampled at times that runs of all rates share, and
// distances between two runs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "jostle/scenes/scene.h"

namespace jostle::sim {

// Step rate and sub-steps of a run.
struct StepSettings {
    double hz = 60;
    int substeps = 8;
    bool operator==(const StepSettings&) const = default;
};

// Sample times: every 1 / hz seconds, `count` times.
struct SampleTimes {
    double hz = 60;
    std::size_t count = 0;
};

struct Trajectory {
    std::size_t bodies = 0;  // number of dynamic bodies
    // centres of mass: all bodies of the first sample, then of the second, and so on
    std::vector<physics::Vec3> at;
    std::vector<physics::Quat> rotations;  // likewise
    double cpu_seconds = 0;                // of the steps only
    std::string failure;                   // why the run ended early; empty: it did not

    std::size_t samples() const { return bodies == 0 ? 0 : at.size() / bodies; }
};

// Simulates a scene. The step rate must be a multiple of the sample rate. Returns an error if the
// scene cannot be built.
physics::Result<Trajectory> simulate_trajectory(scenes::SceneDescription scene,
                                                const StepSettings& setting,
                                                const SampleTimes& samples);

// Returns the scene with `speed` m/s added to every dynamic body, each in a different direction.
scenes::SceneDescription perturbed(scenes::SceneDescription scene, double speed);

// Diagonal of the bounding box of all sampled positions, m.
double extent_of(const Trajectory& trajectory);

// RMS over all bodies.
struct Distance {
    double position = 0;  // m
    double angle = 0;     // rad
};
// Distance over all samples of both runs, or at one sample.
Distance distance_between(const Trajectory& a, const Trajectory& b);
Distance distance_at(const Trajectory& a, const Trajectory& b, std::size_t sample);

}  // namespace jostle::sim
