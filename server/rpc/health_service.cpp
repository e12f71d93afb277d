// SPDX-License-Identifier: MIT
#include "rpc/health_service.h"

#include <algorithm>
#include <chrono>
#include <optional>

namespace jostle::server {

using grpc::health::v1::HealthCheckRequest;
using grpc::health::v1::HealthCheckResponse;

namespace {

constexpr int watchers_max = 16;
// How soon a thread notices that its watcher is gone.
constexpr auto patience = std::chrono::milliseconds(200);

}  // namespace

void HealthService::set_serving(bool serving) {
    {
        const std::lock_guard lock(mutex_);
        serving_ = serving;
    }
    changed_.notify_all();
}

bool HealthService::knows(const std::string& service) const {
    return service.empty() || std::ranges::find(services_, service) != services_.end();
}

grpc::Status HealthService::Check(grpc::ServerContext*, const HealthCheckRequest* request,
                                  HealthCheckResponse* response) {
    if (!knows(request->service())) {
        return {grpc::StatusCode::NOT_FOUND, "there is no service \"" + request->service() + "\""};
    }
    const std::lock_guard lock(mutex_);
    response->set_status(serving_ ? HealthCheckResponse::SERVING
                                  : HealthCheckResponse::NOT_SERVING);
    return grpc::Status::OK;
}

grpc::Status HealthService::Watch(grpc::ServerContext* context, const HealthCheckRequest* request,
                                  grpc::ServerWriter<HealthCheckResponse>* writer) {
    {
        const std::lock_guard lock(mutex_);
        if (watchers_ == watchers_max) {
            return {grpc::StatusCode::RESOURCE_EXHAUSTED, "too many watch already; use Check"};
        }
        watchers_++;
    }
    grpc::Status end = tell_changes(*context, knows(request->service()), *writer);
    const std::lock_guard lock(mutex_);
    watchers_--;
    return end;
}

grpc::Status HealthService::tell_changes(grpc::ServerContext& context, bool known,
                                         grpc::ServerWriter<HealthCheckResponse>& writer) {
    std::optional<Status> told;
    std::unique_lock lock(mutex_);
    while (!context.IsCancelled()) {
        const Status now = !known     ? HealthCheckResponse::SERVICE_UNKNOWN
                           : serving_ ? HealthCheckResponse::SERVING
                                      : HealthCheckResponse::NOT_SERVING;
        if (told == now) {
            changed_.wait_for(lock, patience);
            continue;
        }
        told = now;
        HealthCheckResponse response;
        response.set_status(now);
        lock.unlock();
        const bool written = writer.Write(response);
        lock.lock();
        if (!written) break;
    }
    return grpc::Status::CANCELLED;
}

}  // namespace jostle::server
