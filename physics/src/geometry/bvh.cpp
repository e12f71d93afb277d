// SPDX-License-Identifier: MIT
#include "physics/src/geometry/bvh.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "jostle/base/check.h"

namespace jostle::physics {
namespace {

constexpr std::uint32_t leaf_items = 4;
constexpr int bins = 12;

Aabb empty_box() {
    return {{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}};
}

double area_of(const Aabb& box) {
    return box.low.x > box.high.x ? 0 : half_area(box);
}

struct Cut {
    int axis = -1;
    int bin = 0;  // items of this bin and lower ones go left
    double cost = 1e300;
};

}  // namespace

// A node of the binary tree.
struct Bvh::BinaryNode {
    Aabb box = {};
    // Leaf: first item; otherwise the left child, followed by the right child.
    std::uint32_t first = 0;
    std::uint32_t count = 0;  // items of a leaf; 0 for inner nodes
};

Bvh::Bvh(std::span<const Aabb> boxes) {
    if (boxes.empty()) return;
    items_.resize(boxes.size());
    std::iota(items_.begin(), items_.end(), 0u);
    std::vector<BinaryNode> binary;
    binary.reserve(2 * boxes.size() / leaf_items + 2);
    binary.push_back({.box = {}, .first = 0, .count = static_cast<std::uint32_t>(boxes.size())});
    split(binary, 0, boxes, 1);
    nodes_.reserve(binary.size());
    collapse(binary, 0, boxes, 1);
    ASSERT(height_ <= max_height);
    nodes_.shrink_to_fit();
    items_ = {};
}

void Bvh::split(std::vector<BinaryNode>& binary, std::uint32_t index, std::span<const Aabb> boxes,
                int depth) {
    const std::uint32_t first = binary[index].first, count = binary[index].count;
    ASSERT(count > 0 && first + count <= boxes.size() && depth <= max_height);
    const auto begin = items_.begin() + first, end = begin + count;
    Aabb box = empty_box(), centers = empty_box();
    for (auto it = begin; it != end; ++it) {
        box = unite(box, boxes[*it]);
        const Vec3 c = (boxes[*it].low + boxes[*it].high) * 0.5;
        centers = unite(centers, {c, c});
    }
    binary[index].box = box;
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
        for (Aabb& b : bin_box) b = empty_box();
        for (auto it = begin; it != end; ++it) {
            const int b = bin_of(*it, axis);
            bin_box[b] = unite(bin_box[b], boxes[*it]);
            bin_count[b]++;
        }
        double right_area[bins];
        Aabb sum = empty_box();
        for (int b = bins - 1; b > 0; b--) {
            sum = unite(sum, bin_box[b]);
            right_area[b] = area_of(sum);
        }
        sum = empty_box();
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
    // Equal centres cannot be separated, and a tree that grows too high is split in half by count.
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
    ASSERT(left_count > 0 && left_count < count);
    const auto left = static_cast<std::uint32_t>(binary.size());
    binary.push_back({.box = {}, .first = first, .count = left_count});
    binary.push_back({.box = {}, .first = first + left_count, .count = count - left_count});
    binary[index].first = left;
    binary[index].count = 0;
    split(binary, left, boxes, depth + 1);
    split(binary, left + 1, boxes, depth + 1);
}

// Collapses a binary subtree into a four-way node. Starting from the two children, the largest
// inner node is replaced by its two children until there are four. The children of a leaf are its
// items.
void Bvh::collapse(const std::vector<BinaryNode>& binary, std::uint32_t index,
                   std::span<const Aabb> boxes, int depth) {
    height_ = std::max(height_, depth);
    const std::size_t at = nodes_.size();
    Node& node = nodes_.emplace_back();
    for (int k = 0; k < 4; k++) node.boxes.put_empty(k);
    const BinaryNode& source = binary[index];
    node.leaf = source.count > 0;
    ASSERT(source.count <= leaf_items);
    if (node.leaf) {
        for (std::uint32_t k = 0; k < source.count; k++) {
            node.child[k] = items_[source.first + k];
            node.boxes.put(static_cast<int>(k), boxes[node.child[k]]);
        }
        return;
    }
    std::array<std::uint32_t, 4> children{source.first, source.first + 1};
    int count = 2;
    while (count < 4) {
        int largest = -1;
        for (int k = 0; k < count; k++) {
            const BinaryNode& child = binary[children[k]];
            if (child.count > 0) continue;
            if (largest < 0 || half_area(child.box) > half_area(binary[children[largest]].box))
                largest = k;
        }
        if (largest < 0) break;
        for (int k = count; k > largest + 1; k--) children[k] = children[k - 1];
        children[largest + 1] = binary[children[largest]].first + 1;
        children[largest] = binary[children[largest]].first;
        count++;
    }
    for (int k = 0; k < count; k++) {
        nodes_[at].boxes.put(k, binary[children[k]].box);
        ASSERT(children[k] < binary.size());
        nodes_[at].child[k] = static_cast<std::uint32_t>(nodes_.size());
        collapse(binary, children[k], boxes, depth + 1);
    }
}

}  // namespace jostle::physics
