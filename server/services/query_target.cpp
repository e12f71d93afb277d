// SPDX-License-Identifier: MIT
#include "server/services/query_target.h"

#include <spdlog/fmt/fmt.h>

#include <memory>
#include <utility>

#include "jostle/base/check.h"
#include "jostle/v1/common.pb.h"

namespace jostle::server {

namespace {

Result<QueryFramePtr> frame_of(WorldHost& world, CopyLayers parts) {
    if (QueryFramePtr frame = world.query_frame(parts)) return frame;
    if (world.lifecycle().stopped()) return Error{ErrorCode::unavailable, "the world was closed"};
    return Error{ErrorCode::unavailable,
                 fmt::format("a step of the world took more than {} ms; retry",
                             QueryBroker::timeout.count())};
}

Status check_view_time(const v1::ViewTime& view_time) {
    if (view_time.fraction() >= 0 && view_time.fraction() <= 1) return {};
    return invalid_argument(
        fmt::format("view_time.fraction is {:g}; it must be from 0 to 1", view_time.fraction()));
}

}  // namespace

Result<std::shared_ptr<WorldHost>> queried_world(const WorldDirectory& worlds,
                                                 const std::string& name) {
    std::shared_ptr<WorldHost> world = worlds.find(name);
    if (world) return world;
    return Error{ErrorCode::not_found, name.empty()
                                           ? "the server has no world"
                                           : fmt::format("there is no world \"{}\"", name)};
}

Result<QueryFramePtr> query_frame_of(const WorldDirectory& worlds, const std::string& name,
                                     CopyLayers parts) {
    const Result<std::shared_ptr<WorldHost>> world = queried_world(worlds, name);
    if (!world.ok()) return world.error();
    return frame_of(**world, parts);
}

Result<QueryTarget> query_target(const WorldDirectory& worlds, const std::string& name,
                                 const v1::ViewTime* view_time, bool deformables,
                                 const RewindView::CandidateFilter& candidate_filter) {
    if (view_time)
        if (Status s = check_view_time(*view_time); !s.ok()) return s.error();
    const Result<std::shared_ptr<WorldHost>> world = queried_world(worlds, name);
    if (!world.ok()) return world.error();
    const Result<QueryFramePtr> frame =
        frame_of(**world, copy_shapes | (deformables ? copy_points : 0));
    if (!frame.ok()) return frame.error();
    ASSERT((*frame)->queries);
    QueryTarget target{
        .frame = *frame, .queries = *(*frame)->queries, .points = nullptr, .tick = (*frame)->tick};
    if (!view_time) {
        if (deformables) target.points = (*frame)->point_shapes();
        return target;
    }
    const RewindView past(
        *(*world)->frame_history().at({view_time->tick(), view_time->fraction()}));
    Result<physics::Queries> rewound =
        target.queries.with_shapes_at(past.shapes(*(*frame)->entity_list, candidate_filter));
    if (!rewound.ok()) return Error{ErrorCode::internal, rewound.error().message};
    target.queries = *std::move(rewound);
    target.tick = past.tick();
    target.clamped = past.clamped();
    if (deformables)
        target.points = past.has_points()
                            ? std::make_shared<const PointShapes>(past.points(candidate_filter))
                            : (*frame)->point_shapes();
    return target;
}

}  // namespace jostle::server
