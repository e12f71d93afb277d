// SPDX-License-Identifier: MIT
//
// What a question is asked of: a copy of the world, or its shapes where they were at the moment
// that the client saw. Any thread; may wait a quarter of a second for the copy.
#pragma once

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
    QueryFramePtr frame;  // has the shapes
    physics::Queries queries;
    std::uint32_t tick = 0;
    bool clamped = false;  // an older moment was asked for
};

// unavailable: the world is closed, or its step takes long. not_found: there is no such world.
Result<QueryFramePtr> query_frame_of(const WorldDirectory& worlds, const std::string& world,
                                     CopyLayers parts);

// `seen` null: now. Of the past only what may be met.
Result<QueryTarget> query_target(const WorldDirectory& worlds, const std::string& world,
                                 const v1::ViewTime* view_time,
                                 const RewindView::CandidateFilter& candidate_filter);

// For questions about all of a world.
inline bool any_candidate(physics::Vec3, double) {
    return true;
}

}  // namespace jostle::server
