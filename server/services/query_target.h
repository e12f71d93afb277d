// SPDX-License-Identifier: MIT
//
// The target of a query: a copy of the world, or its shapes at the client's view time (lag
// compensation). Any thread; may wait up to 250 ms for the copy.
#pragma once

#include <memory>
#include <string>

#include "jostle/base/result.h"
#include "server/world/query_frame.h"
#include "server/world/rewind_view.h"
#include "server/world/world_directory.h"

namespace jostle::v1 {
class ViewTime;
}

namespace jostle::server {

struct QueryTarget {
    QueryFramePtr frame;  // copied with its shapes
    physics::Queries queries;
    std::shared_ptr<const PointShapes> points;  // null: the query does not ask for them
    std::uint32_t tick = 0;
    bool clamped = false;  // the view time was older than the oldest frame
};

// The world of a query; an empty name finds the oldest one. not_found: no such world.
Result<std::shared_ptr<WorldHost>> queried_world(const WorldDirectory& worlds,
                                                 const std::string& name);
// unavailable: the world is closed, or its step takes too long. not_found: no such world.
Result<QueryFramePtr> query_frame_of(const WorldDirectory& worlds, const std::string& world,
                                     CopyLayers parts);

// `view_time` null: now. Only candidates that pass the filter are rewound. `deformables`: also the
// shapes of ropes and cloths.
Result<QueryTarget> query_target(const WorldDirectory& worlds, const std::string& world,
                                 const v1::ViewTime* view_time, bool deformables,
                                 const RewindView::CandidateFilter& candidate_filter);

// For queries about the entire world.
inline bool any_candidate(physics::Vec3, double) {
    return true;
}

}  // namespace jostle::server
