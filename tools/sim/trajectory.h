// SPDX-License-Identifier: MIT
//
// How the bodies of a scene move in one run, at times that runs of any rate share, and how far two
// runs are apart.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "jostle/scenes/scene.h"

namespace jostle::sim {

// How a run steps.
struct StepSettings {
    double hz = 60;
    int substeps = 8;
    bool operator==(const StepSettings&) const = default;
};

// Which times are looked at: every 1 / hz seconds, `count` times.
struct SampleTimes {
    double hz = 60;
    std::size_t count = 0;
};

struct Trajectory {
    std::size_t bodies = 0;         // the scene's dynamic ones
    std::vector<physics::Vec3> at;  // centres of mass: all bodies of the first sample, and so on
    std::vector<physics::Quat> rotations;  // likewise
    double cpu_seconds = 0;                // of the steps alone
    std::string failure;                   // why the run ended early; empty: it did not

    std::size_t samples() const { return bodies == 0 ? 0 : at.size() / bodies; }
};

// The setting's rate is a multiple of the samples'. An error says why the scene cannot be built.
physics::Result<Trajectory> simulate_trajectory(scenes::SceneDescription scene,
                                                const StepSettings& setting,
                                                const SampleTimes& samples);

// The same scene with every dynamic body `speed` m/s faster, each in a direction of its own.
scenes::SceneDescription perturbed(scenes::SceneDescription scene, double speed);

// Diagonal of the box around all places of all bodies, m.
double extent_of(const Trajectory& trajectory);

// Root of the mean of squares over all bodies.
struct Distance {
    double position = 0;  // m
    double angle = 0;     // rad
};
// Over all samples of both runs, and at one sample.
Distance distance_between(const Trajectory& a, const Trajectory& b);
Distance distance_at(const Trajectory& a, const Trajectory& b, std::size_t sample);

}  // namespace jostle::sim
