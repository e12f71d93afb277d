// SPDX-License-Identifier: MIT
#include "modules/fields/src/wave_train.h"

#include <algorithm>

#include "jostle/modules/exponential.h"

namespace jostle::modules {

using namespace physics;

namespace fields_detail {
WaveTrain::WaveTrain(const Waves& waves, double gravity, double time)
    : level_(waves.level), flow_(waves.flow) {
    for (const WaveComponent& wave : waves.components) {
        if (wave.amplitude == 0 || count_ == components_.size()) continue;
        const double number = 2 * pi / wave.length,
                     omega = square_root(maximum(gravity, 0) * number);
        const SinCos heading = sin_cos(wave.heading);
        components_[count_++] = {wave.amplitude, number,      omega,
                                 heading.cos,    heading.sin, wave.phase - omega * time};
        sum_ += wave.amplitude;
    }
}

WaveTrain::Sample WaveTrain::at(Vec3 p) const {
    std::array<SinCos, wave_components_max> phases;
    double height = level_;
    Vec3 slope;
    for (std::size_t k = 0; k < count_; k++) {
        const Component& c = components_[k];
        phases[k] = sin_cos(c.number * (c.x * p.x + c.z * p.z) + c.turn);
        height += c.amplitude * phases[k].cos;
        slope -= Vec3{c.x, 0, c.z} * (c.amplitude * c.number * phases[k].sin);
    }
    const double depth = height - p.y;
    if (!(depth > 0)) return {.depth = depth, .slope = slope};
    Sample sample{depth, slope, level_ - p.y, flow_, {0, 1, 0}};
    for (std::size_t k = 0; k < count_; k++) {
        const Component& c = components_[k];
        const double size = c.amplitude * exp_of_negative(-c.number * depth);
        const double crest = size * phases[k].cos, rise = size * phases[k].sin;
        sample.head += crest;
        sample.velocity += Vec3{c.x * crest, rise, c.z * crest} * c.omega;
        sample.lift += (Vec3{c.x * rise, -crest, c.z * rise} + slope * crest) * c.number;
    }
    return sample;
}

// ---- many points ----
//
// Around a body that is short compared with a wave, phase and depth vary little between points. The
// remaining sine, cosine and exponential are short polynomials, which compilers vectorize.

void WaveTrain::sample_pressure(Vec3 center, std::span<const Vec3> arms, double reach,
                                Pressure& pressure) const {
    const std::size_t count = arms.size();
    pressure.depth.resize(count), pressure.head.resize(count);
    pressure.crest.resize(count * count_);
    const double still = level_ - center.y;
    for (std::size_t v = 0; v < count; v++)
        pressure.depth[v] = pressure.head[v] = still - arms[v].y;
    for (std::size_t k = 0; k < count_; k++) {
        double* crest = pressure.crest.data() + k * count;
        add_crest_heights(components_[k], center, arms, reach, crest);
        for (std::size_t v = 0; v < count; v++) pressure.depth[v] += crest[v];
    }
    for (std::size_t k = 0; k < count_; k++)
        fade(components_[k], pressure.depth, pressure.crest.data() + k * count,
             pressure.head.data());
}

// Computes the height of the wave above each point.
void WaveTrain::add_crest_heights(const Component& wave, Vec3 center, std::span<const Vec3> arms,
                                  double reach, double* crest) {
    const double phase = wave.number * (wave.x * center.x + wave.z * center.z) + wave.turn;
    const double along = wave.number * wave.x, across = wave.number * wave.z;
    if (wave.number * reach > 0.8) {
        for (std::size_t v = 0; v < arms.size(); v++)
            crest[v] = wave.amplitude * sin_cos(phase + along * arms[v].x + across * arms[v].z).cos;
        return;
    }
    const SinCos at = sin_cos(phase);
    const double cosine = wave.amplitude * at.cos, sine = wave.amplitude * at.sin;
    for (std::size_t v = 0; v < arms.size(); v++) {
        // cos(phase + x), |x| <= 0.8: Taylor, error below 1e-9.
        const double x = along * arms[v].x + across * arms[v].z, x2 = x * x;
        const double s =
            x * (1 - x2 * (1.0 / 6 - x2 * (1.0 / 120 - x2 * (1.0 / 5040 - x2 * (1.0 / 362880)))));
        const double c = 1 - x2 * (0.5 - x2 * (1.0 / 24 - x2 * (1.0 / 720 - x2 * (1.0 / 40320))));
        crest[v] = cosine * c - sine * s;
    }
}

// Adds the pressure of the wave, which decays with depth.
void WaveTrain::fade(const Component& wave, std::span<const double> depth, const double* crest,
                     double* head) {
    const auto [low, high] = std::ranges::minmax(depth);
    const double middle = 0.5 * (maximum(low, 0) + maximum(high, 0));
    if (wave.number * (maximum(high, 0) - maximum(low, 0)) > 2) {
        for (std::size_t v = 0; v < depth.size(); v++)
            head[v] += crest[v] * exp_of_negative(-wave.number * maximum(depth[v], 0));
        return;
    }
    const double at_middle = exp_of_negative(-wave.number * middle);
    for (std::size_t v = 0; v < depth.size(); v++) {
        // exp(x), |x| <= 1: Taylor, error below 3e-8.
        const double x = wave.number * (middle - maximum(depth[v], 0)), x2 = x * x;
        const double even =
            1 + x2 * (1.0 / 2 + x2 * (1.0 / 24 + x2 * (1.0 / 720 +
                                                       x2 * (1.0 / 40320 + x2 * (1.0 / 3628800)))));
        const double odd =
            1 + x2 * (1.0 / 6 + x2 * (1.0 / 120 + x2 * (1.0 / 5040 + x2 * (1.0 / 362880))));
        head[v] += crest[v] * at_middle * (even + x * odd);
    }
}

double WaveTrain::shortest_wavelength() const {
    double most = 0;
    for (std::size_t k = 0; k < count_; k++) most = maximum(most, components_[k].number);
    return most > 0 ? 2 * pi / most : 1e30;
}

}  // namespace fields_detail

WaterSample water_at(const Waves& waves, double gravity, Vec3 point, double time) {
    const auto sample = fields_detail::WaveTrain(waves, gravity, time).at(point);
    return {point.y + sample.depth, sample.head, sample.velocity};
}

}  // namespace jostle::modules
