// SPDX-License-Identifier: MIT
//
// The poses of entities at a time in the past, as a client rendered them: interpolated between two
// frames along the shorter rotation. Shapes are the current ones; entities that appeared later or
// were removed since are missing. The world itself is not rewound: queries run on the poses of the
// frames. Any thread.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "jostle/base/check.h"
#include "jostle/physics/aabb.h"
#include "jostle/physics/queries.h"
#include "server/world/frame.h"
#include "server/world/point_shapes.h"

namespace jostle::server {

class RewindView {
public:
    explicit RewindView(RewindFrames frames) : frames_(std::move(frames)) {
        ASSERT(frames_.before && frames_.after && frames_.before->tick <= frames_.after->tick);
    }

    std::uint32_t tick() const { return frames_.before->tick; }
    bool clamped() const { return frames_.clamped; }

    // Nothing: the entity did not exist.
    std::optional<physics::Transform> pose_of(EntityId entity) const;

    // The past placements of the shapes of the entities in `now` that pass the filter. The filter
    // gets the bounding sphere of an entity; its radius is infinite for planes.
    using CandidateFilter = std::function<bool(physics::Vec3 center, double radius)>;
    std::vector<physics::ShapePlacement> shapes(const EntityList& now,
                                                const CandidateFilter& candidate_filter) const;

    // The same for the filter along_segment(), without a pass over all entities.
    std::vector<physics::ShapePlacement> shapes_along_segment(const EntityList& now,
                                                              physics::Vec3 origin,
                                                              physics::Vec3 motion) const;

    // The points of ropes, hair and cloth whose spheres pass the filter. Empty if no client
    // subscribed to them then.
    std::vector<PlacedPoints> points(const SphereFilter& filter) const;
    bool has_points() const { return frames_.after->points != nullptr; }

private:
    RewindFrames frames_;
};

// Filters for RewindView::shapes(): the sphere overlaps the segment, or the box.
RewindView::CandidateFilter along_segment(physics::Vec3 origin, physics::Vec3 motion);
RewindView::CandidateFilter within_box(const physics::Aabb& box);

// Interpolates two poses of a body like the clients do. A jump faster than 100 m/s is a teleport
// and yields `a`.
physics::Transform interpolate(const physics::Transform& a, const physics::Transform& b,
                               double fraction, double seconds_apart);

}  // namespace jostle::server
