// SPDX-License-Identifier: MIT
//
// AdminService over gRPC: translate, ask AdminControl, answer. gRPC's synchronous API, like
// WorldService. Callers of this machine only, for as long as nobody says who a caller is.
#pragma once

#include "jostle/v1/admin.grpc.pb.h"
#include "protocol/admin_control.h"

namespace jostle::server {

class AdminService final : public v1::AdminService::Service {
public:
    // Outlives the service.
    explicit AdminService(AdminControl& control) : control_(control) {}

    grpc::Status ListClients(grpc::ServerContext* context, const v1::ListClientsRequest* request,
                             v1::ListClientsResponse* response) override;
    grpc::Status Kick(grpc::ServerContext* context, const v1::KickRequest* request,
                      v1::KickResponse* response) override;
    grpc::Status SetPaused(grpc::ServerContext* context, const v1::SetPausedRequest* request,
                           v1::SetPausedResponse* response) override;
    grpc::Status StepWorld(grpc::ServerContext* context, const v1::StepWorldRequest* request,
                           v1::StepWorldResponse* response) override;
    grpc::Status ExportWorld(grpc::ServerContext* context, const v1::ExportWorldRequest* request,
                             v1::ExportWorldResponse* response) override;
    grpc::Status Drain(grpc::ServerContext* context, const v1::DrainRequest* request,
                       v1::DrainResponse* response) override;
    grpc::Status Profile(grpc::ServerContext* context, const v1::ProfileRequest* request,
                         v1::ProfileResponse* response) override;

private:
    AdminControl& control_;
};

}  // namespace jostle::server
