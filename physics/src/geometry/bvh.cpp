// SPDX-License-Identifier: MIT
#include "geometry/bvh.h"

#include <algorithm>
#include <numeric>

namespace jostle::physics {
namespace {

constexpr std::uint32_t leaf_items = 4;
constexpr int bins = 12;

Aabb nothing() {
    return {{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}};
}

double area_of(const Aabb& box) {
    return box.low.x > box.high.x ? 0 : half_area(box);
}

struct Cut {
    int axis = -1;
    int bin = 0;  // items of this bin and below go left
    double cost = 1e300;
};

}  // namespace

Bvh::Bvh(std::span<const Aabb> boxes) {
    if (boxes.empty()) return;
    items_.resize(boxes.size());
    std::iota(items_.begin(), items_.end(), 0u);
    nodes_.reserve(2 * boxes.size() / leaf_items + 2);
    nodes_.push_back({.box = {}, .first = 0, .count = static_cast<std::uint32_t>(boxes.size())});
    split(0, boxes, 1);
}

void Bvh::split(std::uint32_t index, std::span<const Aabb> boxes, int depth) {
    const std::uint32_t first = nodes_[index].first, count = nodes_[index].count;
    const auto begin = items_.begin() + first, end = begin + count;
    Aabb box = nothing(), centers = nothing();
    for (auto it = begin; it != end; ++it) {
        box = unite(box, boxes[*it]);
        const Vec3 c = (boxes[*it].low + boxes[*it].high) * 0.5;
        centers = unite(centers, {c, c});
    }
    nodes_[index].box = box;
    height_ = std::max(height_, depth);
    if (count <= leaf_items) {
        std::sort(begin, end);
        return;
    }

    const auto bin_of = [&](std::uint32_t item, int axis) {
        const double c = (boxes[item].low[axis] + boxes[item].high[axis]) * 0.5;
        const double width = centers.high[axis] - centers.low[axis];
        return std::clamp(static_cast<int>((c - centers.low[axis]) / width * bins), 0, bins - 1);
    };
    Cut best;
    for (int axis = 0; axis < 3; axis++) {
        if (!(centers.high[axis] - centers.low[axis] > 1e-12)) continue;
        Aabb bin_box[bins];
        int bin_count[bins] = {};
        for (Aabb& b : bin_box) b = nothing();
        for (auto it = begin; it != end; ++it) {
            const int b = bin_of(*it, axis);
            bin_box[b] = unite(bin_box[b], boxes[*it]);
            bin_count[b]++;
        }
        double right_area[bins];
        Aabb sum = nothing();
        for (int b = bins - 1; b > 0; b--) {
            sum = unite(sum, bin_box[b]);
            right_area[b] = area_of(sum);
        }
        sum = nothing();
        int left = 0;
        for (int b = 0; b + 1 < bins; b++) {
            sum = unite(sum, bin_box[b]);
            left += bin_count[b];
            if (left == 0 || left == static_cast<int>(count)) continue;
            const double cost =
                area_of(sum) * left + right_area[b + 1] * (static_cast<int>(count) - left);
            if (cost < best.cost) best = {axis, b, cost};
        }
    }
    auto middle = begin + count / 2;
    // No plane parts equal centres, and a tree that grows too high is cut in half by number.
    if (best.axis >= 0 && depth < max_height - 24) {
        middle = std::stable_partition(
            begin, end, [&](std::uint32_t item) { return bin_of(item, best.axis) <= best.bin; });
    } else {
        const int axis = best.axis < 0 ? 0 : best.axis;
        std::sort(begin, end, [&](std::uint32_t a, std::uint32_t b) {
            const double ca = boxes[a].low[axis] + boxes[a].high[axis];
            const double cb = boxes[b].low[axis] + boxes[b].high[axis];
            return ca < cb || (ca == cb && a < b);
        });
    }
    const auto left_count = static_cast<std::uint32_t>(middle - begin);
    const auto left = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({.box = {}, .first = first, .count = left_count});
    nodes_.push_back({.box = {}, .first = first + left_count, .count = count - left_count});
    nodes_[index].first = left;
    nodes_[index].count = 0;
    split(left, boxes, depth + 1);
    split(left + 1, boxes, depth + 1);
}

}  // namespace jostle::physics
