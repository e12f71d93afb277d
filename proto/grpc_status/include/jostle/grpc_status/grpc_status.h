// SPDX-License-Identifier: MIT
//
// Conversion between Status and grpc::Status. One table serves the server and the clients.
#pragma once

#include <grpcpp/support/status.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "google/rpc/error_details.pb.h"
#include "google/rpc/status.pb.h"
#include "jostle/base/result.h"

namespace jostle {

struct GrpcCode {
    ErrorCode error_code;
    grpc::StatusCode grpc;
};

/// Both directions use the first match: corrupt bytes from a client are an invalid argument.
inline constexpr GrpcCode grpc_codes[] = {
    {ErrorCode::invalid_argument, grpc::StatusCode::INVALID_ARGUMENT},
    {ErrorCode::corrupt_data, grpc::StatusCode::INVALID_ARGUMENT},
    {ErrorCode::not_found, grpc::StatusCode::NOT_FOUND},
    {ErrorCode::failed_precondition, grpc::StatusCode::FAILED_PRECONDITION},
    {ErrorCode::already_exists, grpc::StatusCode::ALREADY_EXISTS},
    {ErrorCode::permission_denied, grpc::StatusCode::PERMISSION_DENIED},
    {ErrorCode::unauthenticated, grpc::StatusCode::UNAUTHENTICATED},
    {ErrorCode::resource_exhausted, grpc::StatusCode::RESOURCE_EXHAUSTED},
    {ErrorCode::deadline_exceeded, grpc::StatusCode::DEADLINE_EXCEEDED},
    {ErrorCode::aborted, grpc::StatusCode::ABORTED},
    {ErrorCode::unavailable, grpc::StatusCode::UNAVAILABLE},
    {ErrorCode::internal, grpc::StatusCode::INTERNAL},
};

inline grpc::Status to_grpc(const Status& status) {
    if (status.ok()) return grpc::Status::OK;
    for (const GrpcCode& code : grpc_codes)
        if (code.error_code == status.error().code) return {code.grpc, status.error().message};
    return {grpc::StatusCode::INTERNAL, status.error().message};
}

/// Returns the time to retry in the details of a status (google.rpc.RetryInfo), ms; 0: none.
inline int retry_after_ms(const grpc::Status& status) {
    google::rpc::Status details;
    if (status.error_details().empty() || !details.ParseFromString(status.error_details()))
        return 0;
    google::rpc::RetryInfo retry;
    for (const google::protobuf::Any& detail : details.details()) {
        if (!detail.Is<google::rpc::RetryInfo>() || !detail.UnpackTo(&retry)) continue;
        const double ms = 1000.0 * static_cast<double>(retry.retry_delay().seconds()) +
                          1e-6 * retry.retry_delay().nanos();
        return static_cast<int>(std::clamp(std::ceil(ms), 0.0, 1e9));
    }
    return 0;
}

/// Converts a gRPC status. Codes that Jostle never sends become `internal`.
/// `retry_after_ms` is that of the details.
inline Status from_grpc(const grpc::Status& status) {
    if (status.ok()) return {};
    Error error{ErrorCode::internal, status.error_message()};
    for (const GrpcCode& code : grpc_codes) {
        if (code.grpc != status.error_code()) continue;
        error.code = code.error_code;
        break;
    }
    if (error.message.empty()) error.message = "the server gave no reason";
    error.retry_after_ms = retry_after_ms(status);
    return error;
}

}  // namespace jostle
