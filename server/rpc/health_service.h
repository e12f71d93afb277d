// SPDX-License-Identifier: MIT
//
// grpc.health.v1.Health, in gRPC's synchronous API. The library's own health service is built on
// its callback API, whose threads poll the play streams' sockets as well and cost a quarter more
// CPU at a hundred clients.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <vector>

#include "grpc/health/v1/health.grpc.pb.h"

namespace jostle::server {

class HealthService final : public grpc::health::v1::Health::Service {
public:
    // The names it knows besides the empty one, which is the server as a whole.
    explicit HealthService(std::vector<std::string> services) : services_(std::move(services)) {}

    // Any thread. All services begin and end together.
    void set_serving(bool serving);

    grpc::Status Check(grpc::ServerContext* context,
                       const grpc::health::v1::HealthCheckRequest* request,
                       grpc::health::v1::HealthCheckResponse* response) override;
    // Holds a thread while it lasts, so only a few are let in.
    grpc::Status Watch(grpc::ServerContext* context,
                       const grpc::health::v1::HealthCheckRequest* request,
                       grpc::ServerWriter<grpc::health::v1::HealthCheckResponse>* writer) override;

private:
    using Status = grpc::health::v1::HealthCheckResponse::ServingStatus;

    bool knows(const std::string& service) const;
    grpc::Status tell_changes(grpc::ServerContext& context, bool known,
                              grpc::ServerWriter<grpc::health::v1::HealthCheckResponse>& writer);

    const std::vector<std::string> services_;
    std::mutex mutex_;
    std::condition_variable changed_;
    bool serving_ = false;
    int watchers_ = 0;
};

}  // namespace jostle::server
