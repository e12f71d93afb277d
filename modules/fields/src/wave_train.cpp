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
        const double number = 2 * pi / wave.length, omega = square_root(gravity * number);
        const SinCos heading = sin_cos(wave.heading);
        components_[count_++] = {wave.amplitude, number,      omega,
                                 heading.cos,    heading.sin, wave.phase - omega * time};
        sum_ += wave.amplitude;
    }
}

WaveTrain::Sample WaveTrain::at(Vec3 p) const {
    std::array<SinCos, wave_components_max> swing;
    double height = level_;
    for (std::size_t k = 0; k < count_; k++) {
        const Component& c = components_[k];
        swing[k] = sin_cos(c.number * (c.x * p.x + c.z * p.z) + c.turn);
        height += c.amplitude * swing[k].cos;
    }
    const double depth = height - p.y;
    if (!(depth > 0)) return {.depth = depth};
    Sample sample{depth, level_ - p.y, flow_};
    for (std::size_t k = 0; k < count_; k++) {
        const Component& c = components_[k];
        const double size = c.amplitude * exp_of_negative(-c.number * depth);
        const double along = size * c.omega * swing[k].cos;
        sample.head += size * swing[k].cos;
        sample.velocity += Vec3{c.x * along, size * c.omega * swing[k].sin, c.z * along};
    }
    return sample;
}

}  // namespace fields_detail

WaterSample water_at(const Waves& waves, double gravity, Vec3 point, double time) {
    const auto sample = fields_detail::WaveTrain(waves, gravity, time).at(point);
    return {point.y + sample.depth, sample.head, sample.velocity};
}

}  // namespace jostle::modules
