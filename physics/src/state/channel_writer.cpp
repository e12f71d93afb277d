// SPDX-License-Identifier: MIT
#include <bit>
#include <limits>

#include "jostle/base/check.h"
#include "jostle/physics/channels.h"
#include "jostle/physics/scalar.h"

namespace jostle::physics {
namespace {

// The nearest whole number of units; NaN is 0.
std::int32_t in_units(double meters, int units_per_meter) {
    constexpr double most = std::numeric_limits<std::int32_t>::max();
    const double units = clamp(meters * units_per_meter, -most, most);
    return units == units ? static_cast<std::int32_t>(units < 0 ? units - 0.5 : units + 0.5) : 0;
}

}  // namespace

bool ChannelWriter::begin(std::size_t kind, BodyId body) {
    const std::uint32_t entity = body == BodyId{} ? 0 : name_of_(body);
    skipping_ = (kind < due_.size() && !due_[kind]) || (entity == 0 && body != BodyId{});
    if (!skipping_) channels_.push_back({static_cast<std::uint32_t>(kind), entity, {}});
    return !skipping_;
}

void ChannelWriter::value(std::int32_t value) {
    if (!skipping_) channels_.back().values.push_back(value);
    ASSERT(skipping_ || !channels_.empty());
}

void ChannelWriter::f32(float number) {
    value(std::bit_cast<std::int32_t>(number));
}

void ChannelWriter::quantized(double number, double low, double high, int bits) {
    ASSERT(bits >= 1 && bits <= 31 && low < high);
    const auto most = static_cast<double>((std::uint32_t{1} << bits) - 1);
    const double share = clamp((number - low) / (high - low), 0, 1);  // NaN: 0
    value(static_cast<std::int32_t>((share > 0 ? share : 0) * most + 0.5));
}

void ChannelWriter::points(int units_per_meter, std::span<const Vec3> points) {
    value(units_per_meter);
    for (const Vec3& p : points)
        for (const double along : {p.x, p.y, p.z}) value(in_units(along, units_per_meter));
}

void ChannelWriter::field(int units_per_meter, std::size_t columns,
                          std::span<const double> heights) {
    ASSERT(columns > 0 && heights.size() % columns == 0);
    value(static_cast<std::int32_t>(columns));
    value(static_cast<std::int32_t>(heights.size() / columns));
    value(units_per_meter);
    for (const double height : heights) value(in_units(height, units_per_meter));
}

}  // namespace jostle::physics
