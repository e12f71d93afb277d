// SPDX-License-Identifier: MIT
#include "physics/src/geometry/bvh.h"

#include <algorithm>
#include <array>
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

// A node of the tree of twos.
struct Bvh::Two {
    Aabb box = {};
    std::uint32_t first = 0;  // leaf: of its items; else the left child, the right one is next
    std::uint32_t count = 0;  // items of a leaf; 0: not a leaf
};

Bvh::Bvh(std::span<const Aabb> boxes) {
    if (boxes.empty()) return;
    items_.resize(boxes.size());
    std::iota(items_.begin(), items_.end(), 0u);
    std::vector<Two> twos;
    twos.reserve(2 * boxes.size() / leaf_items + 2);
    twos.push_back({.box = {}, .first = 0, .count = static_cast<std::uint32_t>(boxes.size())});
    split(twos, 0, boxes, 1);
    nodes_.reserve(twos.size());
    keep(twos, 0, boxes, 1);
    nodes_.shrink_to_fit();
    items_ = {};
}

void Bvh::split(std::vector<Two>& twos, std::uint32_t index, std::span<const Aabb> boxes,
                int depth) {
    const std::uint32_t first = twos[index].first, count = twos[index].count;
    const auto begin = items_.begin() + first, end = begin + count;
    Aabb box = nothing(), centers = nothing();
    for (auto it = begin; it != end; ++it) {
        box = unite(box, boxes[*it]);
        const Vec3 c = (boxes[*it].low + boxes[*it].high) * 0.5;
        centers = unite(centers, {c, c});
    }
    twos[index].box = box;
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
    const auto left = static_cast<std::uint32_t>(twos.size());
    twos.push_back({.box = {}, .first = first, .count = left_count});
    twos.push_back({.box = {}, .first = first + left_count, .count = count - left_count});
    twos[index].first = left;
    twos[index].count = 0;
    split(twos, left, boxes, depth + 1);
    split(twos, left + 1, boxes, depth + 1);
}

// Its children are those of the tree of twos, of which the largest makes room for its own two until
// there are four. A leaf's are its items.
void Bvh::keep(const std::vector<Two>& twos, std::uint32_t index, std::span<const Aabb> boxes,
               int depth) {
    height_ = std::max(height_, depth);
    const std::size_t at = nodes_.size();
    Node& node = nodes_.emplace_back();
    for (int k = 0; k < 4; k++) node.boxes.put_nothing(k);
    const Two& two = twos[index];
    node.leaf = two.count > 0;
    if (node.leaf) {
        for (std::uint32_t k = 0; k < two.count; k++) {
            node.child[k] = items_[two.first + k];
            node.boxes.put(static_cast<int>(k), boxes[node.child[k]]);
        }
        return;
    }
    std::array<std::uint32_t, 4> children{two.first, two.first + 1};
    int count = 2;
    while (count < 4) {
        int largest = -1;
        for (int k = 0; k < count; k++) {
            const Two& child = twos[children[k]];
            if (child.count > 0) continue;
            if (largest < 0 || half_area(child.box) > half_area(twos[children[largest]].box))
                largest = k;
        }
        if (largest < 0) break;
        for (int k = count; k > largest + 1; k--) children[k] = children[k - 1];
        children[largest + 1] = twos[children[largest]].first + 1;
        children[largest] = twos[children[largest]].first;
        count++;
    }
    for (int k = 0; k < count; k++) {
        nodes_[at].boxes.put(k, twos[children[k]].box);
        nodes_[at].child[k] = static_cast<std::uint32_t>(nodes_.size());
        keep(twos, children[k], boxes, depth + 1);
    }
}

}  // namespace jostle::physics
