// SPDX-License-Identifier: MIT
#include "wave_train.h"

#include "exponential.h"

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
    std::array<SinCos, wave_components_max> swing;
    double height = level_;
    Vec3 slope;
    for (std::size_t k = 0; k < count_; k++) {
        const Component& c = components_[k];
        swing[k] = sin_cos(c.number * (c.x * p.x + c.z * p.z) + c.turn);
        height += c.amplitude * swing[k].cos;
        slope -= Vec3{c.x, 0, c.z} * (c.amplitude * c.number * swing[k].sin);
    }
    const double depth = height - p.y;
    if (!(depth > 0)) return {.depth = depth, .slope = slope};
    Sample sample{depth, slope, level_ - p.y, flow_, {0, 1, 0}};
    for (std::size_t k = 0; k < count_; k++) {
        const Component& c = components_[k];
        const double size = c.amplitude * exp_of_negative(-c.number * depth);
        const double crest = size * swing[k].cos, rise = size * swing[k].sin;
        sample.head += crest;
        sample.velocity += Vec3{c.x * crest, rise, c.z * crest} * c.omega;
        sample.lift += (Vec3{c.x * rise, -crest, c.z * rise} + slope * crest) * c.number;
    }
    return sample;
}

double WaveTrain::shortest() const {
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
