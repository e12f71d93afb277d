// SPDX-License-Identifier: MIT
#include "jostle/snapshot/point_codec.h"

#include <algorithm>
#include <cstring>
#include <string>
#include <utility>

#include "jostle/snapshot/crc32.h"
#include "jostle/snapshot/frame_models.h"
#include "jostle/snapshot/point_serializer.h"

namespace jostle::snapshot {
namespace {

Error bad_points(const std::string& what) {
    return {ErrorCode::corrupt_data, "points: " + what};
}

std::size_t points_in(const PointState& state, std::size_t components) {
    return state.values.size() / components;
}

std::uint32_t crc_of(const PointState& state) {
    std::vector<std::byte> bytes;
    bytes.reserve(4 * state.values.size());
    for (const std::int32_t value : state.values)
        for (unsigned k = 0; k < 4; k++)
            bytes.push_back(
                static_cast<std::byte>(static_cast<std::uint32_t>(value) >> (8 * k) & 0xff));
    return crc32(bytes);
}

}  // namespace

const PointModels& start_point_models() {
    static const PointModels models = [] {
        PointModels made;
        const std::span<BitModel> all = all_of(made);
        for (std::size_t i = 0; i < all.size() && i < start_point_model_letters.size(); i++)
            all[i] = model_of_letter(start_point_model_letters[i]);
        return made;
    }();
    return models;
}

PackedPoints encode_points(const PointLayout& layout, const PointOrder& order,
                           const PointState& state, const PointBaselines& baselines,
                           std::size_t levels) {
    PointModels models = start_point_models();
    RangeEncoder out;
    PackedPoints packed;
    write_points(out, models, {layout, order}, state, baselines, levels,
                 [&](std::size_t level) { packed.bytes_of_levels[level] = out.size(); });
    packed.crc = crc_of(state);
    packed.bytes = out.finish();
    packed.bytes_of_levels[levels - 1] = packed.bytes.size();
    // Each level of loose points has about half of the points of the next one.
    for (std::size_t level = levels - 1; layout.form == PointForm::loose && level > 0; level--)
        packed.bytes_of_levels[level - 1] = packed.bytes_of_levels[level] / 2;
    return packed;
}

Result<DecodedPoints> read_points(const PointLayout& layout, const PointOrder& order,
                                  std::uint32_t number, std::span<const std::byte> bytes,
                                  const PointBaselines& available) {
    PointModels models = start_point_models();
    RangeDecoder in(bytes);
    PointSerializer walk(in, models, {layout, order});
    const auto at = [&](const std::string& what) {
        return bad_points(what + " (at byte " + std::to_string(in.byte_position()) + ")");
    };
    const std::size_t components = components_of(layout.form);
    DecodedPoints made;
    made.levels = static_cast<std::size_t>(in.raw(0, point_level_bits)) + 1;
    made.state.number = number;
    const auto used = static_cast<std::size_t>(in.raw(0, point_baseline_bits));
    if (used > available.count())
        return at(std::to_string(used) + " baselines are used; " +
                  std::to_string(available.count()) + " are known");
    const PointBaselines baselines = available.first(used);
    std::size_t count = layout.points;
    if (layout.form == PointForm::loose) {
        const std::size_t before =
            baselines.baseline ? points_in(*baselines.baseline, components) : 0;
        if (!walk.lifetimes(made.state.previous, before)) return at(walk.fault());
        count = made.state.previous.size();
        walk.set_first_birth(baselines.baseline);
    }
    made.state.values.resize(count * components);
    unsigned degree = no_point_degree, scale = 0;
    if (baselines.baseline) {
        degree = static_cast<unsigned>(in.raw(0, point_degree_bits));
        if (degree != no_point_degree && degree > point_degree_limit(number, baselines))
            return at("prediction of degree " + std::to_string(degree) +
                      " needs more or nearer baselines");
    }
    scale = static_cast<unsigned>(in.raw(0, point_scale_bits));
    const PointPredictions predictions =
        predict_points(components, number, count, made.state.previous, baselines, degree);
    if (!walk.values(made.state, predictions, made.levels, scale, [](std::size_t) {}))
        return at(walk.fault());
    if (in.past_end()) return at("truncated data");
    if (!in.at_clean_end()) return at("unexpected bytes at the end");
    coarse_points(layout, order, made.state.values, made.levels);
    made.crc = crc_of(made.state);
    return made;
}

void coarse_points(const PointLayout& layout, const PointOrder& order,
                   std::vector<std::int32_t>& values, std::size_t levels) {
    if (layout.form == PointForm::loose) return;
    const std::size_t components = components_of(layout.form);
    constexpr std::int64_t most = point_coordinate_max;
    for (std::size_t level = levels; level < point_levels; level++)
        for (const PointPredictor& point : order.level(level))
            for (std::size_t c = 0; c < components; c++) {
                std::int64_t sum = 8;  // halves round up
                for (std::uint32_t k = 0; k < point.sources; k++)
                    sum += std::int64_t{point.weight[k]} * values[point.from[k] * components + c];
                values[point.point * components + c] =
                    static_cast<std::int32_t>(std::clamp(sum >> 4, -most, most));
            }
}

}  // namespace jostle::snapshot
