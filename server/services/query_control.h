// SPDX-License-Identifier: MIT
//
// QueryService without a transport, used by gRPC (grpc/query_methods.cpp) and by /api/query over
// HTTP. Any thread; each call may wait up to 250 ms for a copy of the world, and never blocks the
// world.
#pragma once

#include <string>

#include <functional>
#include <mutex>

#include "jostle/base/result.h"
#include "server/limits/query_budget.h"
#include "server/session/play_context.h"
#include "server/world/query_frame.h"

namespace jostle::v1 {
class CastRaysRequest;
class CastRaysResponse;
class CastShapesRequest;
class CastShapesResponse;
class ClosestPointsRequest;
class ClosestPointsResponse;
class DebugRequest;
class DebugResponse;
class InspectRequest;
class InspectResponse;
class OverlapRequest;
class OverlapResponse;
}  // namespace jostle::v1

namespace jostle::server {

using CancellationCheck = std::function<bool()>;

class QueryControl {
public:
    static bool always() { return true; }

    explicit QueryControl(PlayContext& context)
        : context_(context), budget_(context.config.quota.query_share) {}

    // The processor time of queries. Transports charge a call from decoding to encoding.
    QueryBudget& budget() const { return budget_; }

    // Calls with many parts check between them whether the response is still needed.
    Status cast_rays(const v1::CastRaysRequest& request, v1::CastRaysResponse& response,
                     const CancellationCheck& still_needed = always) const;
    Status cast_shapes(const v1::CastShapesRequest& request, v1::CastShapesResponse& response,
                       const CancellationCheck& still_needed = always) const;
    Status overlap(const v1::OverlapRequest& request, v1::OverlapResponse& response,
                   const CancellationCheck& still_needed = always) const;
    Status closest_points(const v1::ClosestPointsRequest& request,
                          v1::ClosestPointsResponse& response,
                          const CancellationCheck& still_needed = always) const;
    Status debug(const v1::DebugRequest& request, v1::DebugResponse& response,
                 const CancellationCheck& still_needed = always) const;
    Status inspect(const v1::InspectRequest& request, v1::InspectResponse& response,
                   const CancellationCheck& still_needed = always) const;
    // The two halves of debug(), for callers that cache responses: the same request on the same
    // copy has the same response.
    Result<QueryFramePtr> debug_frame(const v1::DebugRequest& request) const;
    static void write_debug(const v1::DebugRequest& request, const QueryFrame& frame,
                            v1::DebugResponse& response);

private:
    PlayContext& context_;
    mutable QueryBudget budget_;
    mutable std::mutex inspects_;  // one at a time, because the world runs one task at a time
};

}  // namespace jostle::server
