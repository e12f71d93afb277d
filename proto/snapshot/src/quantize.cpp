// SPDX-License-Identifier: MIT
#include "jostle/snapshot/quantize.h"

#include <algorithm>
#include <cmath>

namespace jostle::snapshot {
namespace {

// Nearest integer in the range; 0 for NaN.
std::int32_t round_to(double x, double low, double high) {
    if (std::isnan(x)) return 0;
    return static_cast<std::int32_t>(std::nearbyint(std::clamp(x, low, high)));
}

// The sum of the squares of three components of a unit quaternion never exceeds that of all four. A
// decoder rejects a frame with a larger sum, so an invalid rotation must not be encoded.
bool is_rotation(const EntityState& state, const QuantSpec& spec) {
    std::int64_t sum = 0;
    for (const std::int64_t r : state.rotation) sum += r * r;
    return sum <= 2 * std::int64_t{spec.rotation_component} * spec.rotation_component;
}

}  // namespace

EntityState quantize(std::uint32_t id, const Pose& pose, bool at_rest, const QuantSpec& spec) {
    EntityState state{.id = id, .at_rest = at_rest};
    for (std::size_t k = 0; k < 3; k++)
        state.position[k] =
            round_to(pose.position[k] * spec.units_per_meter, -2147483648.0, 2147483647.0);
    std::size_t largest = 0;
    for (std::size_t k = 1; k < 4; k++)
        if (std::fabs(pose.rotation[k]) > std::fabs(pose.rotation[largest])) largest = k;
    // q and -q are the same rotation; the one whose largest component is positive is sent.
    const double m = spec.rotation_component;
    const double scale = (pose.rotation[largest] < 0 ? -1 : 1) * m * 1.4142135623730951;
    state.largest = static_cast<std::uint8_t>(largest);
    std::size_t to = 0;
    for (std::size_t k = 0; k < 4; k++)
        if (k != largest)
            state.rotation[to++] =
                static_cast<std::int16_t>(round_to(pose.rotation[k] * scale, -m, m));
    if (!is_rotation(state, spec)) state.largest = 3, state.rotation = {};
    return state;
}

Pose dequantize(const EntityState& state, const QuantSpec& spec) {
    Pose pose;
    for (std::size_t k = 0; k < 3; k++)
        pose.position[k] = state.position[k] / static_cast<double>(spec.units_per_meter);
    const double scale = 1 / (spec.rotation_component * 1.4142135623730951);
    double rest = 1;
    std::size_t from = 0;
    for (std::size_t k = 0; k < 4; k++) {
        if (k == state.largest) continue;
        pose.rotation[k] = state.rotation[from++] * scale;
        rest -= pose.rotation[k] * pose.rotation[k];
    }
    pose.rotation[state.largest] = std::sqrt(std::max(rest, 0.0));
    return pose;
}

}  // namespace jostle::snapshot
