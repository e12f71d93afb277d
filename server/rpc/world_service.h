// SPDX-License-Identifier: MIT
//
// WorldService over gRPC: translate, ask WorldControl, answer. gRPC's synchronous API: these calls
// are few, may take as long as building a world, and its threads leave the play streams' completion
// queues alone.
#pragma once

#include "jostle/v1/world.grpc.pb.h"
#include "protocol/world_control.h"

namespace jostle::server {

class WorldService final : public v1::WorldService::Service {
public:
    // Outlives the service.
    explicit WorldService(WorldControl& worlds) : worlds_(worlds) {}

    grpc::Status ListWorlds(grpc::ServerContext* context, const v1::ListWorldsRequest* request,
                            v1::ListWorldsResponse* response) override;
    grpc::Status GetWorld(grpc::ServerContext* context, const v1::GetWorldRequest* request,
                          v1::GetWorldResponse* response) override;
    grpc::Status CreateWorld(grpc::ServerContext* context, const v1::CreateWorldRequest* request,
                             v1::CreateWorldResponse* response) override;
    grpc::Status DeleteWorld(grpc::ServerContext* context, const v1::DeleteWorldRequest* request,
                             v1::DeleteWorldResponse* response) override;
    grpc::Status JoinWorld(grpc::ServerContext* context, const v1::JoinWorldRequest* request,
                           v1::JoinWorldResponse* response) override;

private:
    WorldControl& worlds_;
};

}  // namespace jostle::server
