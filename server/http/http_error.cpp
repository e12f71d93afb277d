// SPDX-License-Identifier: MIT
#include "server/http/http_error.h"

#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

namespace jostle::server {

namespace {

// Maps errors to HTTP status codes, with the names of the corresponding gRPC codes.
struct HttpCode {
    ErrorCode error_code;
    int status;
    std::string_view name;
};

constexpr HttpCode http_codes[] = {
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

}  // namespace

HttpResponse json_response(int status, std::string body) {
    HttpResponse response;
    response.status = status;
    response.content_type = "application/json";
    response.headers.emplace_back("Cache-Control", "no-store");
    response.body = std::move(body);
    return response;
}

HttpResponse to_http(const Error& error) {
    const HttpCode code = http_code_of(error.code);
    nlohmann::json body = {{"code", code.name}, {"message", error.message}};
    if (error.retry_after_ms > 0) body["retryAfterMs"] = error.retry_after_ms;
    HttpResponse response = json_response(
        code.status, body.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
    // Whole seconds, rounded up.
    const int seconds = error.retry_after_ms > 0 ? (error.retry_after_ms + 999) / 1000 : 5;
    if (code.status == 503 || code.status == 429)
        response.headers.emplace_back("Retry-After", std::to_string(seconds));
    if (code.status == 401) response.headers.emplace_back("WWW-Authenticate", "Bearer");
    return response;
}

}  // namespace jostle::server
