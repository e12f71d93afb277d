// SPDX-License-Identifier: MIT
#include "modules/crowd/src/wall_tree.h"

#include <algorithm>

namespace jostle::modules::crowd_detail {

using namespace physics;

namespace {

constexpr std::uint32_t leaf_walls = 4;
constexpr std::size_t depth_max = 32;  // of the tree: halving 2^32 walls

double squared_distance_to_box(Vec2 p, Vec2 low, Vec2 high) {
    const double x = maximum(maximum(low.x - p.x, p.x - high.x), 0);
    const double y = maximum(maximum(low.y - p.y, p.y - high.y), 0);
    return x * x + y * y;
}

Vec2 offset_to(const Wall& wall, Vec2 p) {
    const Vec2 along = wall.to - wall.from;
    const double squared = length_squared(along);
    const double t = squared > 0 ? clamp(dot(p - wall.from, along) / squared, 0, 1) : 0;
    // Exact at the ends, so that walls that share a corner have the same offset there.
    if (t == 0) return wall.from - p;
    if (t == 1) return wall.to - p;
    return wall.from + along * t - p;
}

}  // namespace

void WallTree::build(std::span<const Wall> walls) {
    walls_.assign(walls.begin(), walls.end());
    nodes_.clear();
    if (!walls_.empty()) add_node(0, static_cast<std::uint32_t>(walls_.size()));
}

std::uint32_t WallTree::add_node(std::uint32_t first, std::uint32_t count) {
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    Node node{walls_[first].from, walls_[first].from, first, count, 0};
    for (std::uint32_t k = first; k < first + count; k++)
        for (const Vec2 p : {walls_[k].from, walls_[k].to}) {
            node.low = {minimum(node.low.x, p.x), minimum(node.low.y, p.y)};
            node.high = {maximum(node.high.x, p.x), maximum(node.high.y, p.y)};
        }
    nodes_.push_back(node);
    if (count <= leaf_walls) return index;
    const bool wide = node.high.x - node.low.x >= node.high.y - node.low.y;
    const auto middle = [wide](const Wall& wall) {
        return wide ? wall.from.x + wall.to.x : wall.from.y + wall.to.y;
    };
    const auto begin = walls_.begin() + first;
    std::stable_sort(begin, begin + count,
                     [&](const Wall& a, const Wall& b) { return middle(a) < middle(b); });
    add_node(first, count / 2);
    const std::uint32_t right = add_node(first + count / 2, count - count / 2);
    nodes_[index].count = 0;
    nodes_[index].right = right;
    return index;
}

// Calls visit(offset, squared distance) for each wall within reach; it returns false to stop.
template <class Visit>
void WallTree::visit_near(Vec2 point, double reach, const Visit& visit) const {
    if (nodes_.empty()) return;
    std::array<std::uint32_t, depth_max + 1> stack;
    std::size_t size = 0;
    stack[size++] = 0;
    const double reach_squared = reach * reach;
    while (size > 0) {
        const std::uint32_t index = stack[--size];
        const Node& node = nodes_[index];
        if (squared_distance_to_box(point, node.low, node.high) > reach_squared) continue;
        if (node.count == 0) {
            stack[size++] = node.right;
            stack[size++] = index + 1;
            continue;
        }
        for (std::uint32_t k = node.first; k < node.first + node.count; k++) {
            const Vec2 offset = offset_to(walls_[k], point);
            const double squared = length_squared(offset);
            if (squared <= reach_squared && !visit(walls_[k], offset, squared)) return;
        }
    }
}

void WallTree::find(Vec2 point, double reach, NearWalls& found) const {
    found.count = 0;
    visit_near(point, reach, [&](const Wall& wall, Vec2 offset, double squared) {
        NearWall near{offset, square_root(squared),
                      offset == wall.from - point || offset == wall.to - point};
        if (near.distance == 0) {  // on the wall: any side
            const Vec2 along = wall.to - wall.from;
            const double size = length(along);
            near.offset = size > 0 ? Vec2{-along.y / size, along.x / size} : Vec2{1, 0};
        }
        auto& list = found.walls;
        for (std::size_t k = 0; k < found.count; k++)
            if (list[k].offset == near.offset) return true;
        if (found.count == near_walls_max && near.distance >= list[near_walls_max - 1].distance)
            return true;
        std::size_t at = found.count < near_walls_max ? found.count++ : near_walls_max - 1;
        for (; at > 0 && near.distance < list[at - 1].distance; at--) list[at] = list[at - 1];
        list[at] = near;
        return true;
    });
}

bool WallTree::is_near(Vec2 point, double reach) const {
    bool near = false;
    visit_near(point, reach, [&](const Wall&, Vec2, double) {
        near = true;
        return false;
    });
    return near;
}

}  // namespace jostle::modules::crowd_detail
