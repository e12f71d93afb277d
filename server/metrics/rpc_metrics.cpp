// SPDX-License-Identifier: MIT
#include "server/metrics/rpc_metrics.h"

#include <array>

#include "jostle/base/check.h"

namespace jostle::server {

namespace {

// gRPC status codes by number.
constexpr std::array<std::string_view, 17> code_names = {
    "OK",
    "CANCELLED",
    "UNKNOWN",
    "INVALID_ARGUMENT",
    "DEADLINE_EXCEEDED",
    "NOT_FOUND",
    "ALREADY_EXISTS",
    "PERMISSION_DENIED",
    "RESOURCE_EXHAUSTED",
    "FAILED_PRECONDITION",
    "ABORTED",
    "OUT_OF_RANGE",
    "UNIMPLEMENTED",
    "INTERNAL",
    "UNAVAILABLE",
    "DATA_LOSS",
    "UNAUTHENTICATED",
};
constexpr int unknown_code = 2;

const prometheus::Histogram::BucketBoundaries seconds_buckets = {
    0.0005, 0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1, 5};

}  // namespace

RpcMetrics::RpcMetrics(Metrics& metrics) : metrics_(metrics) {
    methods_[""] = {.service = "unknown", .name = "unknown"};
}

// The series exist with 0 from the start: a rate is only visible for a series that existed before.
void RpcMetrics::add(const std::string& path, Kind kind) {
    const std::lock_guard lock(mutex_);
    const std::size_t slash = path.rfind('/');
    ASSERT(path.starts_with('/') && slash > 0);
    Method& method = methods_[path];
    method.service = path.substr(1, slash - 1);
    method.name = path.substr(slash + 1);
    counter_of(method, 0);
    if (kind == Kind::unary)
        method.seconds = &metrics_.rpc_seconds.Add(
            {{"grpc_service", method.service}, {"grpc_method", method.name}}, seconds_buckets);
}

prometheus::Counter& RpcMetrics::counter_of(Method& method, int code) {
    ASSERT(code >= 0 && code < static_cast<int>(code_names.size()));
    prometheus::Counter*& counter = method.by_code[code];
    if (!counter)
        counter = &metrics_.rpcs_handled.Add(
            {{"grpc_service", method.service},
             {"grpc_method", method.name},
             {"grpc_code", std::string(code_names[static_cast<std::size_t>(code)])}});
    return *counter;
}

void RpcMetrics::handled(std::string_view path, int code, double seconds) {
    const bool is_known_code = code >= 0 && code < static_cast<int>(code_names.size());
    const std::lock_guard lock(mutex_);
    auto at = methods_.find(path);
    if (at == methods_.end()) at = methods_.find("");
    ASSERT(at != methods_.end());
    counter_of(at->second, is_known_code ? code : unknown_code).Increment();
    if (at->second.seconds) at->second.seconds->Observe(seconds);
}

}  // namespace jostle::server
