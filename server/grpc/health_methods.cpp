// SPDX-License-Identifier: MIT
#include "server/grpc/server_methods.h"

#include <algorithm>

#include "grpc/health/v1/health.pb.h"

namespace jostle::server {

using grpc::health::v1::HealthCheckRequest;
using grpc::health::v1::HealthCheckResponse;

std::vector<CallMethod> health_methods(std::vector<std::string> services,
                                       std::function<bool()> is_serving) {
    const auto status_of = [services = std::move(services),
                            is_serving = std::move(is_serving)](const std::string& service) {
        if (!service.empty() && std::ranges::find(services, service) == services.end())
            return HealthCheckResponse::SERVICE_UNKNOWN;
        return is_serving() ? HealthCheckResponse::SERVING : HealthCheckResponse::NOT_SERVING;
    };
    const auto check = [status_of](const CallContext&, const HealthCheckRequest& request,
                                   HealthCheckResponse& response) -> Status {
        response.set_status(status_of(request.service()));
        if (response.status() != HealthCheckResponse::SERVICE_UNKNOWN) return {};
        return Error{ErrorCode::not_found, "there is no service \"" + request.service() + "\""};
    };
    // An unknown service is reported to the watcher, which waits for it to appear.
    const auto watch = [status_of](const CallContext&, const HealthCheckRequest& request,
                                   HealthCheckResponse& response) -> Status {
        response.set_status(status_of(request.service()));
        return {};
    };
    constexpr std::size_t request_bytes_max = 1024;
    const std::string service = "/grpc.health.v1.Health/";
    CallMethod checks = unary_method<HealthCheckRequest, HealthCheckResponse>(
        service + "Check", CallWork::quick, request_bytes_max, check);
    checks.is_probe = true;
    return {std::move(checks), unary_method<HealthCheckRequest, HealthCheckResponse>(
                                   service + "Watch", CallWork::watch, request_bytes_max, watch)};
}

}  // namespace jostle::server
