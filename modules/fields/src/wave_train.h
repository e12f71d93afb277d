// SPDX-License-Identifier: MIT
//
// Waves at one time, prepared for evaluation at many points.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "jostle/modules/waves.h"

namespace jostle::modules::fields_detail {

class WaveTrain {
public:
    WaveTrain() = default;  // still water at level 0
    WaveTrain(const Waves& waves, double gravity, double time);

    struct Sample {
        double depth = 0;             // m below the surface; negative above it
        physics::Vec3 slope = {};     // of the surface: d height / dx, 0, d height / dz
        double head = 0;              // m of water; 0 above the surface
        physics::Vec3 velocity = {};  // m/s; 0 above the surface
        // -grad head: buoyant force on a small volume, divided by the weight of the water it
        // displaces.
        physics::Vec3 lift = {};
    };
    Sample at(physics::Vec3 point) const;

    // Evaluates many points around a centre, at most `reach` (m) from it: equal to at(center + arm)
    // within 1e-7 of a wave's amplitude. Reuses the memory of `pressure`.
    struct Pressure {
        // as in Sample; the head of points above the surface is undefined
        std::vector<double> depth, head;
        std::vector<double> crest;  // m, one wave after the other
    };
    void sample_pressure(physics::Vec3 center, std::span<const physics::Vec3> arms, double reach,
                         Pressure& pressure) const;

    double shortest_wavelength() const;  // m, of all waves; 1e30 without waves
    // m, y of the highest possible crest
    double max_surface_height() const { return level_ + sum_; }

private:
    struct Component {
        double amplitude, number, omega;  // m, 1/m, 1/s
        double x, z;                      // heading
        double turn;                      // rad, phase at this time
    };
    static void add_crest_heights(const Component& wave, physics::Vec3 center,
                                  std::span<const physics::Vec3> arms, double reach, double* crest);
    static void fade(const Component& wave, std::span<const double> depth, const double* crest,
                     double* head);
    std::array<Component, wave_components_max> components_ = {};
    std::size_t count_ = 0;
    double level_ = 0, sum_ = 0;
    physics::Vec3 flow_;
};

}  // namespace jostle::modules::fields_detail
