// SPDX-License-Identifier: MIT
//
// WorldService over gRPC: translate, ask WorldControl, answer. Called on gRPC's own threads.
#pragma once

#include "jostle/v1/world.grpc.pb.h"
#include "protocol/world_control.h"

namespace jostle::server {

class WorldService final : public v1::WorldService::CallbackService {
public:
    // Outlives the service.
    explicit WorldService(WorldControl& worlds) : worlds_(worlds) {}

    grpc::ServerUnaryReactor* ListWorlds(grpc::CallbackServerContext* context,
                                         const v1::ListWorldsRequest* request,
                                         v1::ListWorldsResponse* response) override;
    grpc::ServerUnaryReactor* GetWorld(grpc::CallbackServerContext* context,
                                       const v1::GetWorldRequest* request,
                                       v1::GetWorldResponse* response) override;
    grpc::ServerUnaryReactor* CreateWorld(grpc::CallbackServerContext* context,
                                          const v1::CreateWorldRequest* request,
                                          v1::CreateWorldResponse* response) override;
    grpc::ServerUnaryReactor* DeleteWorld(grpc::CallbackServerContext* context,
                                          const v1::DeleteWorldRequest* request,
                                          v1::DeleteWorldResponse* response) override;
    grpc::ServerUnaryReactor* JoinWorld(grpc::CallbackServerContext* context,
                                        const v1::JoinWorldRequest* request,
                                        v1::JoinWorldResponse* response) override;

private:
    WorldControl& worlds_;
};

}  // namespace jostle::server
