// SPDX-License-Identifier: MIT
//
// Walls: line segments in the plane, in a tree of boxes that finds those near a point. Built when
// the walls change; queries may run concurrently.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "jostle/physics/vec2.h"

namespace jostle::modules::crowd_detail {

struct Wall {
    physics::Vec2 from, to;  // m

    bool operator==(const Wall&) const = default;
};

// The nearest point of a wall.
struct NearWall {
    physics::Vec2 offset;  // m, from the query point; of unit length if the distance is 0
    double distance = 0;   // m
    bool is_end = false;   // the nearest point is an end of the wall
};

// Maximum number of walls that a query returns.
inline constexpr std::size_t near_walls_max = 12;

struct NearWalls {
    std::array<NearWall, near_walls_max> walls;  // nearest first
    std::size_t count = 0;
};

class WallTree {
public:
    void build(std::span<const Wall> walls);
    // Lists the nearest points of the nearest walls within `reach` m. Walls that share the point,
    // such as at a corner, count once.
    void find(physics::Vec2 point, double reach, NearWalls& found) const;
    // Whether a wall is within `reach` m of the point.
    bool is_near(physics::Vec2 point, double reach) const;
    bool empty() const { return walls_.empty(); }

private:
    struct Node {
        physics::Vec2 low, high;
        std::uint32_t first = 0, count = 0;  // walls of a leaf; an inner node has count 0
        std::uint32_t right = 0;             // second child of an inner node; the first one follows
    };
    std::uint32_t add_node(std::uint32_t first, std::uint32_t count);
    template <class Visit>
    void visit_near(physics::Vec2 point, double reach, const Visit& visit) const;

    std::vector<Wall> walls_;
    std::vector<Node> nodes_;
};

}  // namespace jostle::modules::crowd_detail
