// SPDX-License-Identifier: MIT
//
// A uniform grid over the positions of all entities of one frame: finds the entities near a segment
// without a pass over all of them. The grid is two-dimensional, over the two longer axes of the
// world. Immutable; any thread.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <vector>

#include "jostle/physics/vec3.h"
#include "server/world/pose_list.h"

namespace jostle::server {

class PoseGrid {
public:
    // `radii`: the bounding radius of each entity, in the order of the list; may be infinite.
    PoseGrid(const PoseList& poses, const std::vector<double>& radii);

    // Appends the indices of all entities whose bounding spheres, grown by `margin`, may touch the
    // segment, and of some others.
    void append_near_segment(physics::Vec3 origin, physics::Vec3 motion, double margin,
                             std::vector<std::uint32_t>& indices) const;

private:
    double along(const physics::Vec3& v, int axis) const;
    int cell_of(double x, int axis) const;

    int axes_[2] = {0, 2};
    int cells_ = 1;  // per axis; the border cells extend to infinity
    double low_[2] = {}, size_[2] = {1, 1};
    double radius_max_ = 0;                // of the entities in cells
    std::vector<std::uint32_t> first_;     // by cell: index in entities_; one more at the end
    std::vector<std::uint32_t> entities_;  // sorted by cell
    std::vector<std::uint32_t> large_;     // entities that are too large for cells
};

// A grid that is built when it is first needed. Copies start without one.
class LazyPoseGrid {
public:
    LazyPoseGrid() = default;
    LazyPoseGrid(const LazyPoseGrid&) {}
    LazyPoseGrid& operator=(const LazyPoseGrid&) = delete;

    template <class Build>
    const PoseGrid& get(Build&& build) const {
        std::call_once(once_, [&] { grid_.emplace(build()); });
        return *grid_;
    }

private:
    mutable std::once_flag once_;
    mutable std::optional<PoseGrid> grid_;
};

}  // namespace jostle::server
