// SPDX-License-Identifier: MIT
//
// Our answers as gRPC statuses.
#pragma once

#include <grpcpp/support/status.h>

#include "protocol/answer.h"

namespace jostle::server {

inline grpc::Status to_grpc_status(const Answer& answer) {
    const auto status = [&](grpc::StatusCode code) { return grpc::Status(code, answer.message); };
    switch (answer.code) {
        case AnswerCode::ok:
            return grpc::Status::OK;
        case AnswerCode::invalid_argument:
            return status(grpc::StatusCode::INVALID_ARGUMENT);
        case AnswerCode::not_found:
            return status(grpc::StatusCode::NOT_FOUND);
        case AnswerCode::already_exists:
            return status(grpc::StatusCode::ALREADY_EXISTS);
        case AnswerCode::failed_precondition:
            return status(grpc::StatusCode::FAILED_PRECONDITION);
        case AnswerCode::unauthenticated:
            return status(grpc::StatusCode::UNAUTHENTICATED);
        case AnswerCode::resource_exhausted:
            return status(grpc::StatusCode::RESOURCE_EXHAUSTED);
        case AnswerCode::deadline_exceeded:
            return status(grpc::StatusCode::DEADLINE_EXCEEDED);
        case AnswerCode::aborted:
            return status(grpc::StatusCode::ABORTED);
        case AnswerCode::unavailable:
            return status(grpc::StatusCode::UNAVAILABLE);
        case AnswerCode::internal:
            return status(grpc::StatusCode::INTERNAL);
    }
    return status(grpc::StatusCode::INTERNAL);
}

}  // namespace jostle::server
