// SPDX-License-Identifier: MIT
//
// The traversal of a state of a point object, shared by encoder and decoder. The Coder codes each
// bit with its model and returns the coded bit. Only the codec itself and the program that trains
// the initial models include this header.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "jostle/snapshot/point_layout.h"
#include "jostle/snapshot/point_models.h"
#include "jostle/snapshot/point_predictions.h"
#include "jostle/snapshot/point_state.h"

namespace jostle::snapshot {

inline constexpr unsigned point_level_bits = 2, point_baseline_bits = 2, point_degree_bits = 2,
                          point_scale_bits = 4;

struct PointTopology {
    const PointLayout& layout;
    const PointOrder& order;
};

template <class Coder>
class PointSerializer {
public:
    PointSerializer(Coder& coder, PointModels& models, const PointTopology& topology)
        : coder_(coder),
          models_(models),
          layout_(topology.layout),
          order_(topology.order),
          components_(components_of(topology.layout.form)) {}

    /// Codes which loose points disappeared and appeared: PointState::previous. `baseline`: the
    /// number of points before. Returns false if a decoder found an error; see fault().
    bool lifetimes(std::vector<std::uint32_t>& previous, std::size_t baseline) {
        std::vector<std::uint32_t> survivors;
        if (!gone(survivors, previous, baseline)) return false;
        const std::uint64_t born =
            code_count(coder_, models_.born, previous.size() - survivors.size());
        if (born > points_max - survivors.size()) return fail("more points than the limit");
        return births(survivors, previous, static_cast<std::size_t>(born));
    }

    /// Codes the values of the first `levels` levels. A decoder's `state` has its final size.
    /// `scale`: the first expected magnitude, 0 to 15. `on_level` is called after each level.
    template <class OnLevel>
    bool values(PointState& state, const PointPredictions& predictions, std::size_t levels,
                unsigned scale, const OnLevel& on_level) {
        start_expectations(scale);
        if (layout_.form == PointForm::loose) return loose(state, predictions) && !ended();
        residuals_.assign(state.values.size(), 0);
        for (std::size_t level = 0; level < levels; level++) {
            for (const PointPredictor& point : order_.level(level))
                if (!connected(state, predictions, point) || ended()) return false;
            on_level(level);
        }
        return true;
    }

    /// Where the first new loose point is predicted: the last point of the baseline.
    void set_first_birth(const PointState* baseline) {
        if (!baseline || baseline->values.size() < components_) return;
        for (std::size_t c = 0; c < components_; c++)
            first_birth_[c] = baseline->values[baseline->values.size() - components_ + c];
    }

    const std::string& fault() const { return fault_; }

private:
    static constexpr std::size_t depths_max = 3, components_max = 3;
    static constexpr std::int64_t residual_cap = 1 << 16;
    static constexpr unsigned birth_scale = 10;

    bool fail(const char* what) {
        if (fault_.empty()) fault_ = what;
        return false;
    }
    bool ended() {
        if constexpr (Coder::encoding)
            return false;
        else
            return coder_.past_end() && !fail("truncated data");
    }

    // ---- loose points ----

    bool gone(std::vector<std::uint32_t>& survivors, const std::vector<std::uint32_t>& previous,
              std::size_t baseline) {
        std::size_t next = 0;  // of previous
        bool last = false;
        for (std::uint32_t point = 0; point < baseline; point++) {
            if constexpr (Coder::encoding)
                while (next < previous.size() &&
                       (previous[next] == no_point || previous[next] < point))
                    next++;
            const bool survives = next < previous.size() && previous[next] == point;
            last = coder_.bit(models_.gone[last ? 1 : 0], !survives);
            if (!last) survivors.push_back(point);
            if (ended()) return false;
        }
        return true;
    }

    bool births(const std::vector<std::uint32_t>& survivors, std::vector<std::uint32_t>& previous,
                std::size_t born) {
        const std::size_t total = survivors.size() + born;
        if constexpr (!Coder::encoding) previous.assign(total, 0);
        bool last = true;
        if constexpr (Coder::encoding)
            for (std::size_t i = 0; i < survivors.size(); i++) last &= previous[i] != no_point;
        if (born > 0) last = coder_.bit(models_.born_last, last);
        std::uint64_t at = last ? survivors.size() : 0;
        for (std::size_t i = 0; i < born; i++, at++) {
            if (!last) {
                std::uint64_t gap = 0;
                if constexpr (Coder::encoding)
                    while (previous[static_cast<std::size_t>(at + gap)] != no_point) gap++;
                at += code_count(coder_, models_.born_gap, gap);
            }
            if (at >= total) return fail("new point past the end");
            if constexpr (!Coder::encoding) previous[static_cast<std::size_t>(at)] = no_point;
        }
        if constexpr (!Coder::encoding) {
            std::size_t next = 0;
            for (std::uint32_t& index : previous)
                if (index != no_point) index = survivors[next++];
        }
        return !ended();
    }

    // A new point is predicted at the previous new one; all others are offset by the mean of the
    // last residuals, because wind and gravity act on all of them alike.
    bool loose(PointState& state, const PointPredictions& predictions) {
        std::array<std::int64_t, components_max> newest = first_birth_;
        std::array<std::array<std::int64_t, components_max>, depths_max> offsets{};
        for (std::size_t point = 0; point < predictions.depths.size(); point++) {
            const std::size_t depth = predictions.depths[point];
            for (std::size_t c = 0; c < components_; c++) {
                const std::size_t at = point * components_ + c;
                std::int64_t& offset = offsets[depth][c];
                const std::int64_t predicted =
                    depth == 0 ? newest[c] : predictions.values[at] + offset / 16;
                if (!value(state, at, predicted, depth, c, expected_[depth][c], offset < 0))
                    return false;
                if (depth == 0)
                    newest[c] = state.values[at];
                else
                    offset +=
                        (16 * clamped(state.values[at] - predictions.values[at]) - offset) / 8;
            }
            if (ended()) return false;
        }
        return true;
    }

    // ---- connected points ----

    // Offsets the prediction by how far the sources of the point were from theirs.
    bool connected(PointState& state, const PointPredictions& predictions,
                   const PointPredictor& point) {
        const std::size_t depth = predictions.depths[point.point];
        for (std::size_t c = 0; c < components_; c++) {
            const std::size_t at = point.point * components_ + c;
            std::int64_t offset = 0, off = 0;
            for (std::uint32_t k = 0; k < point.sources; k++) {
                const std::size_t source = point.from[k] * components_ + c;
                offset += point.weight[k] * (state.values[source] - predictions.values[source]);
                off += residuals_[source];
            }
            std::int64_t expected = expected_[depth][c];
            if (point.sources > 0) expected = (expected + 16 * off / point.sources) / 2;
            if (!value(state, at, predictions.values[at] + offset / 16, depth, c, expected,
                       offset < 0))
                return false;
        }
        return true;
    }

    // ---- residuals ----

    static std::int64_t clamped(std::int64_t residual) {
        return std::clamp(residual, -residual_cap, residual_cap);
    }
    void start_expectations(unsigned scale) {
        for (auto& expected : expected_) expected.fill(scale == 0 ? 0 : std::int64_t{2} << scale);
        if (layout_.form == PointForm::loose) expected_[0].fill(std::int64_t{2} << birth_scale);
    }
    static std::size_t class_of(std::int64_t expected) {
        const auto size = static_cast<std::uint64_t>(expected);
        const unsigned width = bit_width(size);
        if (width < 2) return 0;
        return std::min<std::size_t>(2 * (width - 2) + 1 + (size >> (width - 2) & 1),
                                     PointModels::classes - 1);
    }

    // Codes one coordinate. `back`: the residual probably is negative.
    bool value(PointState& state, std::size_t at, std::int64_t predicted, std::size_t depth,
               std::size_t component, std::int64_t expected, bool back) {
        const std::size_t model = class_of(expected);
        const std::int64_t error = state.values[at] - predicted;
        const std::int64_t coded =
            code_number(coder_, models_.size[model], models_.tail[model], back ? -error : error);
        const std::int64_t made = predicted + (back ? -coded : coded);
        if (made < -point_coordinate_max || made > point_coordinate_max)
            return fail("coordinate out of range");
        state.values[at] = static_cast<std::int32_t>(made);
        const std::int64_t size = std::min(coded < 0 ? -coded : coded, residual_cap);
        std::int64_t& mean = expected_[depth][component];
        mean += (16 * size - mean) / 8;
        if (!residuals_.empty()) residuals_[at] = static_cast<std::int32_t>(size);
        return true;
    }

    Coder& coder_;
    PointModels& models_;
    const PointLayout& layout_;
    const PointOrder& order_;
    const std::size_t components_;
    std::array<std::int64_t, components_max> first_birth_ = {};
    // Mean magnitude of the last residuals, in sixteenths, by depth and component.
    std::array<std::array<std::int64_t, components_max>, depths_max> expected_ = {};
    std::vector<std::int32_t> residuals_;  // magnitudes
    std::string fault_;
};

/// Writes a state; see encode_points().
template <class Coder, class OnLevel>
void write_points(Coder& out, PointModels& models, const PointTopology& topology,
                  const PointState& state, const PointBaselines& baselines, std::size_t levels,
                  const OnLevel& on_level) {
    PointState walked = state;
    PointSerializer walk(out, models, topology);
    out.raw(levels - 1, point_level_bits);
    out.raw(baselines.count(), point_baseline_bits);
    if (topology.layout.form == PointForm::loose) {
        const std::size_t components = components_of(topology.layout.form);
        walk.lifetimes(walked.previous,
                       baselines.baseline ? baselines.baseline->values.size() / components : 0);
        walk.set_first_birth(baselines.baseline);
    }
    const PointPlan plan = plan_points(topology.layout, topology.order, state, baselines);
    if (baselines.baseline) out.raw(plan.degree, point_degree_bits);
    out.raw(plan.scale, point_scale_bits);
    walk.values(walked, plan.predictions, levels, plan.scale, on_level);
}

}  // namespace jostle::snapshot
