// SPDX-License-Identifier: MIT
//
// Grid of points that lists the nearest neighbours of a point. The cells of a row are consecutive
// buckets of a table, so a query reads few contiguous ranges; the table does not grow with the area
// that the points cover. Results depend only on the positions and their order.
//
// Rebuilt without allocation after the first time. Queries may run concurrently.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "jostle/physics/vec3.h"

namespace jostle::modules::crowd_detail {

// Maximum number of points that a query returns.
inline constexpr std::size_t nearest_max = 24;

// A point near another one, ordered by gap, then by index.
struct NearPoint {
    double gap = 0;  // m^2: squared distance minus squared sum of radii
    std::uint32_t index = 0;

    bool operator<(const NearPoint& other) const {
        return gap < other.gap || (gap == other.gap && index < other.index);
    }
};

inline double gap_between(physics::Vec3 a, double radius_a, physics::Vec3 b, double radius_b) {
    const physics::Vec3 offset = b - a;
    const double radii = radius_a + radius_b;
    return dot(offset, offset) - radii * radii;
}

// Sorted list of the nearest points.
struct NearPoints {
    std::array<NearPoint, nearest_max> points;
    std::size_t count = 0;
};

class NeighborGrid {
public:
    // Stores the points k with active[k]. Cells divide x and y, or x, y and z if not flat;
    // distances are always three-dimensional. `reach`, m: neighbours have a gap of at most its
    // square.
    void build(std::span<const physics::Vec3> points, std::span<const double> radii,
               std::span<const std::uint8_t> active, double reach, bool flat);
    // Lists the `most` points with the smallest gap to points[self] within reach. `bound`: at least
    // `most` points have at most this gap; 1e300 if unknown.
    void find(std::size_t self, std::size_t most, double bound, NearPoints& found) const;

    double smallest_radius() const { return smallest_radius_; }
    double largest_radius() const { return largest_radius_; }

private:
    struct Entry {
        physics::Vec3 point;
        double radius = 0;
        std::uint32_t index = 0;
        std::int32_t row = 0, layer = 0;
    };
    struct Query;

    std::int32_t cell_of(double x) const;
    void scan(std::uint32_t begin, std::uint32_t end, std::int32_t row, std::int32_t layer,
              Query& query) const;

    double reach_ = 0, cells_per_meter_ = 0, smallest_radius_ = 0, largest_radius_ = 0;
    bool flat_ = true;
    std::uint32_t mask_ = 0;                       // number of buckets - 1
    std::vector<std::uint32_t> starts_;            // first entry of each bucket
    std::vector<Entry> entries_;                   // by bucket
    std::vector<std::uint32_t> buckets_, places_;  // of each point: its bucket, its entry
};

}  // namespace jostle::modules::crowd_detail
