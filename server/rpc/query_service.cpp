// SPDX-License-Identifier: MIT
#include "rpc/query_service.h"

#include "rpc/unary_call.h"

namespace jostle::server {

grpc::Status QueryService::CastRays(grpc::ServerContext* context,
                                    const v1::CastRaysRequest* request,
                                    v1::CastRaysResponse* response) {
    return answer(*context, [&] { return queries_.cast_rays(*request, *response); });
}

grpc::Status QueryService::CastShapes(grpc::ServerContext* context,
                                      const v1::CastShapesRequest* request,
                                      v1::CastShapesResponse* response) {
    return answer(*context, [&] { return queries_.cast_shapes(*request, *response); });
}

grpc::Status QueryService::Overlap(grpc::ServerContext* context, const v1::OverlapRequest* request,
                                   v1::OverlapResponse* response) {
    return answer(*context, [&] { return queries_.overlap(*request, *response); });
}

grpc::Status QueryService::ClosestPoints(grpc::ServerContext* context,
                                         const v1::ClosestPointsRequest* request,
                                         v1::ClosestPointsResponse* response) {
    return answer(*context, [&] { return queries_.closest_points(*request, *response); });
}

grpc::Status QueryService::Debug(grpc::ServerContext* context, const v1::DebugRequest* request,
                                 v1::DebugResponse* response) {
    return answer(*context, [&] { return queries_.debug(*request, *response); });
}

}  // namespace jostle::server
