// SPDX-License-Identifier: MIT
//
// The connections of the points of a point object, and the order in which the points are coded
// (WIRE.md, "Points"). The order has levels: level 0 is a coarse version of the object, and each
// further level adds the points between those of the levels before it. Any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "jostle/base/result.h"

namespace jostle::snapshot {

inline constexpr std::size_t points_max = 65536;             ///< per object
inline constexpr std::size_t point_triangles_max = 131072;   ///< per object
inline constexpr std::size_t point_objects_max = 1024;       ///< of a world
inline constexpr std::size_t world_points_max = 128 * 1024;  ///< of all objects of a world
inline constexpr std::size_t point_levels = 4;

enum class PointForm : std::uint8_t {
    loose = 1,      ///< unconnected points; their number changes from state to state
    strands = 2,    ///< ropes and hair: polylines
    grid = 3,       ///< a sheet of columns x rows points, row by row
    triangles = 4,  ///< a mesh
    heights = 5,    ///< columns x rows heights above a horizontal grid, row by row
};

/// Constant during the lifetime of an object.
struct PointLayout {
    PointForm form = PointForm::loose;
    std::uint32_t points = 0;              ///< 0 for loose points
    std::uint32_t columns = 0;             ///< grid, heights: divides `points`
    std::vector<std::uint32_t> strands;    ///< number of points of each strand
    std::vector<std::uint32_t> triangles;  ///< three points each

    bool operator==(const PointLayout&) const = default;
};

/// Integers per point: a height, or x, y and z.
inline std::size_t components_of(PointForm form) {
    return form == PointForm::heights ? 1 : 3;
}

/// Checks an untrusted layout. Returns corrupt_data with the reason if it is invalid.
Status check_layout(const PointLayout& layout);

/// A point and the points of the same or earlier levels from which it is predicted, each with a
/// weight in sixteenths. The weights of one point have the sum 16.
struct PointPredictor {
    static constexpr std::size_t sources_max = 4;
    std::uint32_t point = 0, sources = 0;
    std::array<std::uint32_t, sources_max> from = {};
    std::array<std::int32_t, sources_max> weight = {};

    void add(std::uint32_t source, std::int32_t sixteenths) {
        from[sources] = source;
        weight[sources++] = sixteenths;
    }
};

/// All points of a layout, except of loose points, in coding order.
class PointOrder {
public:
    PointOrder() = default;
    /// Precondition: check_layout() accepts the layout.
    explicit PointOrder(const PointLayout& layout);

    /// The points of one level, 0 to point_levels - 1.
    std::span<const PointPredictor> level(std::size_t level) const {
        return std::span(points_).subspan(begin_[level], begin_[level + 1] - begin_[level]);
    }

private:
    void add_strands(const PointLayout& layout, std::size_t level);
    void add_grid(const PointLayout& layout, std::size_t level);
    void add_triangles(const PointLayout& layout);

    std::vector<PointPredictor> points_;
    std::array<std::size_t, point_levels + 1> begin_ = {};
};

}  // namespace jostle::snapshot
