// SPDX-License-Identifier: MIT
//
// QueryService over gRPC: translate, ask QueryControl, answer. gRPC's synchronous API, like
// WorldService, and for the same reasons.
#pragma once

#include "jostle/v1/query.grpc.pb.h"
#include "protocol/query_control.h"

namespace jostle::server {

class QueryService final : public v1::QueryService::Service {
public:
    // Outlives the service.
    explicit QueryService(const QueryControl& queries) : queries_(queries) {}

    grpc::Status CastRays(grpc::ServerContext* context, const v1::CastRaysRequest* request,
                          v1::CastRaysResponse* response) override;
    grpc::Status CastShapes(grpc::ServerContext* context, const v1::CastShapesRequest* request,
                            v1::CastShapesResponse* response) override;
    grpc::Status Overlap(grpc::ServerContext* context, const v1::OverlapRequest* request,
                         v1::OverlapResponse* response) override;
    grpc::Status ClosestPoints(grpc::ServerContext* context,
                               const v1::ClosestPointsRequest* request,
                               v1::ClosestPointsResponse* response) override;
    grpc::Status Debug(grpc::ServerContext* context, const v1::DebugRequest* request,
                       v1::DebugResponse* response) override;

private:
    const QueryControl& queries_;
};

}  // namespace jostle::server
