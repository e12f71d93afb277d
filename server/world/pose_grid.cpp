// SPDX-License-Identifier: MIT
#include "server/world/pose_grid.h"

#include <algorithm>
#include <cmath>

#include "jostle/base/check.h"

namespace jostle::server {

using physics::Vec3;

namespace {

constexpr int cells_max = 256;  // per axis
constexpr double entities_per_cell = 4;
constexpr std::size_t samples_max = 512;
constexpr double large_cells = 2;  // bounding radius in cells above which an entity is in no cell

double component(const Vec3& v, int axis) {
    return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

// The range that contains 96 % of the sampled values: a few distant entities do not widen it.
struct Range {
    double low = 0, high = 0;
};
Range range_of(std::vector<double>& values) {
    if (values.empty()) return {};
    std::ranges::sort(values);
    const std::size_t cut = values.size() / 50;
    return {values[cut], values[values.size() - 1 - cut]};
}

}  // namespace

double PoseGrid::along(const Vec3& v, int axis) const {
    return component(v, axes_[axis]);
}

int PoseGrid::cell_of(double x, int axis) const {
    return static_cast<int>(std::clamp((x - low_[axis]) / size_[axis], 0.0, cells_ - 0.5));
}

PoseGrid::PoseGrid(const PoseList& poses, const std::vector<double>& radii) {
    ASSERT(poses.size() == radii.size());
    Range ranges[3];
    const std::size_t stride = std::max<std::size_t>(1, poses.size() / samples_max);
    for (int axis = 0; axis < 3; axis++) {
        std::vector<double> values;
        for (std::size_t i = 0; i < poses.size(); i += stride)
            values.push_back(component(poses[i].pose.position, axis));
        ranges[axis] = range_of(values);
    }
    const auto width = [&](int axis) { return ranges[axis].high - ranges[axis].low; };
    int shortest = 0;
    for (int axis = 1; axis < 3; axis++)
        if (width(axis) < width(shortest)) shortest = axis;
    axes_[0] = shortest == 0 ? 1 : 0;
    axes_[1] = shortest == 2 ? 1 : 2;
    const double wanted = std::sqrt(static_cast<double>(poses.size()) / entities_per_cell);
    cells_ = static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(cells_max)));
    for (int k = 0; k < 2; k++) {
        low_[k] = ranges[axes_[k]].low;
        size_[k] = std::max(width(axes_[k]) / cells_, 1e-6);
    }
    const double radius_limit = large_cells * std::max(size_[0], size_[1]);
    std::vector<std::uint32_t> cell_of_entity(poses.size());
    const auto none = static_cast<std::uint32_t>(cells_ * cells_);
    first_.assign(none + 1, 0);
    std::size_t i = 0;
    for (const EntityPose& entity : poses) {
        const double radius = radii[i];
        // Written so that a radius or a position that is not a number counts as large.
        const Vec3 p = entity.pose.position;
        const bool fits = radius <= radius_limit && std::isfinite(p.x + p.y + p.z);
        if (fits) {
            radius_max_ = std::max(radius_max_, radius);
            cell_of_entity[i] = static_cast<std::uint32_t>(cell_of(along(p, 1), 1) * cells_ +
                                                           cell_of(along(p, 0), 0));
            first_[cell_of_entity[i] + 1]++;
        } else {
            cell_of_entity[i] = none;
            large_.push_back(static_cast<std::uint32_t>(i));
        }
        i++;
    }
    for (std::size_t cell = 1; cell < first_.size(); cell++) first_[cell] += first_[cell - 1];
    entities_.resize(poses.size() - large_.size());
    std::vector<std::uint32_t> at(first_.begin(), first_.end() - 1);
    for (std::uint32_t entity = 0; entity < cell_of_entity.size(); entity++)
        if (cell_of_entity[entity] != none) entities_[at[cell_of_entity[entity]]++] = entity;
}

// Row by row: the part of the segment whose distance from the row allows a touch, and the cells
// around it.
void PoseGrid::append_near_segment(Vec3 origin, Vec3 motion, double margin,
                                   std::vector<std::uint32_t>& indices) const {
    indices.insert(indices.end(), large_.begin(), large_.end());
    if (entities_.empty()) return;
    const double reach = (radius_max_ + margin) * 1.000001 + 1e-6;
    const double from[2] = {along(origin, 0), along(origin, 1)};
    const double to[2] = {from[0] + along(motion, 0), from[1] + along(motion, 1)};
    const int first_row = cell_of(std::min(from[1], to[1]) - reach, 1);
    const int last_row = cell_of(std::max(from[1], to[1]) + reach, 1);
    for (int row = first_row; row <= last_row; row++) {
        // The border rows extend to infinity.
        const bool first = row == 0, last = row == cells_ - 1;
        const double below = low_[1] + row * size_[1] - reach;
        const double above = low_[1] + (row + 1) * size_[1] + reach;
        double enter = 0, leave = 1;
        if (const double step = to[1] - from[1]; step != 0) {
            const double a = (below - from[1]) / step, b = (above - from[1]) / step;
            if (!(step > 0 ? first : last)) enter = std::max(enter, step > 0 ? a : b);
            if (!(step > 0 ? last : first)) leave = std::min(leave, step > 0 ? b : a);
            if (enter > leave) continue;
        }
        const double a = from[0] + (to[0] - from[0]) * enter,
                     b = from[0] + (to[0] - from[0]) * leave;
        const int left = cell_of(std::min(a, b) - reach, 0),
                  right = cell_of(std::max(a, b) + reach, 0);
        const auto cell = static_cast<std::size_t>(row * cells_);
        const std::uint32_t begin = first_[cell + static_cast<std::size_t>(left)];
        const std::uint32_t end = first_[cell + static_cast<std::size_t>(right) + 1];
        indices.insert(indices.end(), entities_.begin() + begin, entities_.begin() + end);
    }
}

}  // namespace jostle::server
