// SPDX-License-Identifier: MIT
//
// Maps errors to HTTP status codes, with the names of the corresponding gRPC codes.
#pragma once

#include <string_view>

#include "jostle/base/result.h"

namespace jostle::server {

struct HttpCode {
    ErrorCode error_code;
    int status;
    std::string_view name;
};

inline constexpr HttpCode http_codes[] = {
    {ErrorCode::invalid_argument, 400, "INVALID_ARGUMENT"},
    {ErrorCode::corrupt_data, 400, "INVALID_ARGUMENT"},
    {ErrorCode::not_found, 404, "NOT_FOUND"},
    {ErrorCode::failed_precondition, 409, "FAILED_PRECONDITION"},
    {ErrorCode::already_exists, 409, "ALREADY_EXISTS"},
    {ErrorCode::permission_denied, 403, "PERMISSION_DENIED"},
    {ErrorCode::unauthenticated, 401, "UNAUTHENTICATED"},
    {ErrorCode::resource_exhausted, 429, "RESOURCE_EXHAUSTED"},
    {ErrorCode::deadline_exceeded, 504, "DEADLINE_EXCEEDED"},
    {ErrorCode::aborted, 409, "ABORTED"},
    {ErrorCode::unavailable, 503, "UNAVAILABLE"},
    {ErrorCode::internal, 500, "INTERNAL"},
};

constexpr HttpCode http_code_of(ErrorCode error) {
    for (const HttpCode& code : http_codes)
        if (code.error_code == error) return code;
    return {ErrorCode::internal, 500, "INTERNAL"};
}

}  // namespace jostle::server
