// SPDX-License-Identifier: MIT
#include "jostle/client/world_client.h"

#include <grpcpp/create_channel.h>

#include <chrono>

#include "jostle/v1/world.grpc.pb.h"

namespace jostle::client {
namespace {

constexpr auto patience = std::chrono::seconds(5);

}  // namespace

struct WorldClient::Impl {
    std::unique_ptr<v1::WorldService::Stub> stub;

    template <class Request, class Response>
    std::optional<std::string> call(grpc::Status (v1::WorldService::Stub::*method)(
                                        grpc::ClientContext*, const Request&, Response*),
                                    const Request& request, Response& response) {
        grpc::ClientContext context;
        context.set_deadline(std::chrono::system_clock::now() + patience);
        context.set_wait_for_ready(true);
        const grpc::Status status = (stub.get()->*method)(&context, request, &response);
        if (status.ok()) return std::nullopt;
        return status.error_message();
    }
};

WorldClient::WorldClient(const std::string& target) : impl_(std::make_unique<Impl>()) {
    impl_->stub =
        v1::WorldService::NewStub(grpc::CreateChannel(target, grpc::InsecureChannelCredentials()));
}
WorldClient::~WorldClient() = default;

std::optional<std::string> WorldClient::list(v1::ListWorldsResponse& response) {
    return impl_->call(&v1::WorldService::Stub::ListWorlds, v1::ListWorldsRequest(), response);
}

std::optional<std::string> WorldClient::create(const v1::CreateWorldRequest& request,
                                               v1::CreateWorldResponse& response) {
    return impl_->call(&v1::WorldService::Stub::CreateWorld, request, response);
}

std::optional<std::string> WorldClient::remove(const std::string& world) {
    v1::DeleteWorldRequest request;
    request.set_world(world);
    v1::DeleteWorldResponse response;
    return impl_->call(&v1::WorldService::Stub::DeleteWorld, request, response);
}

std::optional<std::string> WorldClient::join(const std::string& world,
                                             v1::JoinWorldResponse& response) {
    v1::JoinWorldRequest request;
    request.set_world(world);
    return impl_->call(&v1::WorldService::Stub::JoinWorld, request, response);
}

}  // namespace jostle::client
