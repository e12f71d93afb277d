// SPDX-License-Identifier: MIT
#include "rpc/world_service.h"

#include "rpc/unary_call.h"

namespace jostle::server {

grpc::Status WorldService::ListWorlds(grpc::ServerContext* context,
                                      const v1::ListWorldsRequest* request,
                                      v1::ListWorldsResponse* response) {
    return answer(*context, [&] { return worlds_.list(*request, *response); });
}

grpc::Status WorldService::GetWorld(grpc::ServerContext* context,
                                    const v1::GetWorldRequest* request,
                                    v1::GetWorldResponse* response) {
    return answer(*context, [&] { return worlds_.get(*request, *response); });
}

grpc::Status WorldService::CreateWorld(grpc::ServerContext* context,
                                       const v1::CreateWorldRequest* request,
                                       v1::CreateWorldResponse* response) {
    return answer(*context, [&]() -> Status {
        Status created = worlds_.create(*request, *response);
        if (!created.ok() || !is_too_late(*context)) return created;
        // The caller has given up on a world that it does not know of: it would run for nobody.
        v1::DeleteWorldRequest removal;
        removal.set_world(response->world().id());
        v1::DeleteWorldResponse removed;
        if (Status s = worlds_.remove(removal, removed); !s.ok()) return s;
        return Error{ErrorCode::deadline_exceeded,
                     "building the world took longer than the deadline"};
    });
}

grpc::Status WorldService::DeleteWorld(grpc::ServerContext* context,
                                       const v1::DeleteWorldRequest* request,
                                       v1::DeleteWorldResponse* response) {
    return answer(*context, [&] { return worlds_.remove(*request, *response); });
}

grpc::Status WorldService::JoinWorld(grpc::ServerContext* context,
                                     const v1::JoinWorldRequest* request,
                                     v1::JoinWorldResponse* response) {
    return answer(*context, [&] { return worlds_.join(*request, *response); });
}

}  // namespace jostle::server
