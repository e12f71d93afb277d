// SPDX-License-Identifier: MIT
//
// Waves at one moment, ready to be asked at many points.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "jostle/modules/waves.h"

namespace jostle::modules::fields_detail {

class WaveTrain {
public:
    WaveTrain() = default;  // still water at 0
    WaveTrain(const Waves& waves, double gravity, double time);

    struct Sample {
        double depth = 0;             // m below the surface over the point; < 0: above it
        physics::Vec3 slope = {};     // of the surface: d height / dx, 0, d height / dz
        double head = 0;              // m of water; 0 above the surface
        physics::Vec3 velocity = {};  // m/s; 0 above the surface
        // - grad head: how hard the water pushes a small volume, over its weight in water.
        physics::Vec3 lift = {};
    };
    Sample at(physics::Vec3 point) const;

    // Of many points about a center, no further from it than `reach` (m): at(center + arm) to 1e-7
    // of a wave's amplitude. Memory used again.
    struct Pressure {
        std::vector<double> depth, head;  // as in Sample; the head of dry points has no meaning
        std::vector<double> crest;        // m, of one wave after the other
    };
    void sample_pressure(physics::Vec3 center, std::span<const physics::Vec3> arms, double reach,
                         Pressure& pressure) const;

    double shortest_wavelength() const;                          // m, of all waves; 1e30 without
    double max_surface_height() const { return level_ + sum_; }  // m, y that no crest passes

private:
    struct Component {
        double amplitude, number, omega;  // m, 1/m, 1/s
        double x, z;                      // heading
        double turn;                      // rad, of the moment
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
