// SPDX-License-Identifier: MIT
#include <bit>

#include "jostle/base/check.h"
#include "jostle/physics/channels.h"
#include "jostle/physics/scalar.h"

namespace jostle::physics {
bool ChannelWriter::begin(std::size_t kind, BodyId body) {
    const std::uint32_t entity = body == BodyId{} ? 0 : name_of_(body);
    skipping_ = !is_due(kind) || (entity == 0 && body != BodyId{});
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

bool ChannelWriter::points(std::size_t kind, const PointObject& object) {
    if (!wants_points(kind)) return false;
    const std::uint32_t entity = object.body == BodyId{} ? 0 : name_of_(object.body);
    if (entity == 0 && object.body != BodyId{}) return false;
    on_points_(static_cast<std::uint32_t>(kind), entity, object);
    return true;
}

}  // namespace jostle::physics
