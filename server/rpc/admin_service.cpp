// SPDX-License-Identifier: MIT
#include "rpc/admin_service.h"

#include <string_view>

#include "rpc/unary_call.h"

namespace jostle::server {

namespace {

// As gRPC names peers: "ipv4:127.0.0.1:4711", "ipv6:%5B::1%5D:4711".
bool is_of_this_machine(std::string_view peer) {
    return peer.starts_with("ipv4:127.") || peer.starts_with("ipv6:[::1]") ||
           peer.starts_with("ipv6:%5B::1%5D") || peer.starts_with("unix:");
}

template <class Work>
grpc::Status answer_operator(const grpc::ServerContext& context, const Work& work) {
    if (!is_of_this_machine(context.peer())) {
        return {grpc::StatusCode::PERMISSION_DENIED,
                "operators' calls are taken from this machine alone; log in there"};
    }
    return answer(context, work);
}

}  // namespace

grpc::Status AdminService::ListClients(grpc::ServerContext* context,
                                       const v1::ListClientsRequest* request,
                                       v1::ListClientsResponse* response) {
    return answer_operator(*context, [&] { return control_.list_clients(*request, *response); });
}

grpc::Status AdminService::Kick(grpc::ServerContext* context, const v1::KickRequest* request,
                                v1::KickResponse* response) {
    return answer_operator(*context, [&] { return control_.kick(*request, *response); });
}

grpc::Status AdminService::SetPaused(grpc::ServerContext* context,
                                     const v1::SetPausedRequest* request,
                                     v1::SetPausedResponse* response) {
    return answer_operator(*context, [&] { return control_.set_paused(*request, *response); });
}

grpc::Status AdminService::StepWorld(grpc::ServerContext* context,
                                     const v1::StepWorldRequest* request,
                                     v1::StepWorldResponse* response) {
    return answer_operator(*context, [&] { return control_.step_world(*request, *response); });
}

grpc::Status AdminService::ExportWorld(grpc::ServerContext* context,
                                       const v1::ExportWorldRequest* request,
                                       v1::ExportWorldResponse* response) {
    return answer_operator(*context, [&] { return control_.export_world(*request, *response); });
}

grpc::Status AdminService::Drain(grpc::ServerContext* context, const v1::DrainRequest* request,
                                 v1::DrainResponse* response) {
    return answer_operator(*context, [&] { return control_.drain(*request, *response); });
}

grpc::Status AdminService::Profile(grpc::ServerContext* context, const v1::ProfileRequest* request,
                                   v1::ProfileResponse* response) {
    return answer_operator(*context, [&] { return control_.profile(*request, *response); });
}

}  // namespace jostle::server
