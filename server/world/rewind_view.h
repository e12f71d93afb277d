// SPDX-License-Identifier: MIT
//
// Where everything was at a moment of the past, as a client saw it: between two frames, along the
// shorter way. Shapes are those of now; what came later is not there, and neither is what is gone
// by now. Nothing is rewound: poses are read from frames and asked about with the solver's own
// queries. Any thread.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "jostle/physics/aabb.h"
#include "jostle/physics/queries.h"
#include "server/world/frame_ring.h"

namespace jostle::server {

class RewindView {
public:
    explicit RewindView(RewindFrames checkpoint_copy) : moment_(std::move(checkpoint_copy)) {}

    std::uint32_t tick() const { return moment_.before->tick; }
    bool clamped() const { return moment_.clamped; }

    // Nothing when the entity was not there.
    std::optional<physics::Transform> pose_of(EntityId entity) const;

    // Shapes of entities of `now`, where they were, of those that may be met: by a ball around an
    // entity, whose radius is infinite for planes.
    using CandidateFilter = std::function<bool(physics::Vec3 center, double radius)>;
    std::vector<physics::ShapePlacement> shapes(const EntityList& now,
                                                const CandidateFilter& candidate_filter) const;

private:
    RewindFrames moment_;
};

// For RewindView::shapes(): whether a ball meets the segment, or the box.
RewindView::CandidateFilter along_segment(physics::Vec3 origin, physics::Vec3 motion);
RewindView::CandidateFilter within_box(const physics::Aabb& box);

// Between two poses of a body, as clients blend them: a leap that 100 m/s do not explain is seen
// when it is over.
physics::Transform interpolate(const physics::Transform& a, const physics::Transform& b,
                               double fraction, double seconds_apart);

}  // namespace jostle::server
