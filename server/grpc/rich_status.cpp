// SPDX-License-Identifier: MIT
#include "server/grpc/rich_status.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

#include "google/rpc/error_details.pb.h"
#include "google/rpc/status.pb.h"
#include "jostle/grpc_status/grpc_status.h"

namespace jostle::server {

namespace {

constexpr int retry_ms = 1000;            // if a limit was reached
constexpr int retry_elsewhere_ms = 5000;  // if the server shuts down or a world is busy

std::string_view reason_of(ErrorCode code) {
    switch (code) {
        case ErrorCode::invalid_argument:
        case ErrorCode::corrupt_data:
            return "INVALID_ARGUMENT";
        case ErrorCode::not_found:
            return "NOT_FOUND";
        case ErrorCode::failed_precondition:
            return "FAILED_PRECONDITION";
        case ErrorCode::already_exists:
            return "NAME_TAKEN";
        case ErrorCode::permission_denied:
            return "NOT_ALLOWED";
        case ErrorCode::unauthenticated:
            return "NO_CREDENTIALS";
        case ErrorCode::resource_exhausted:
            return "LIMIT";
        case ErrorCode::deadline_exceeded:
            return "TOO_LATE";
        case ErrorCode::aborted:
            return "ENDED";
        case ErrorCode::unavailable:
            return "UNAVAILABLE";
        case ErrorCode::internal:
            return "FAULT_OF_THE_SERVER";
    }
    return "UNKNOWN";
}

// Messages about a field start with its path: "scene.bodies[3].shapes[0]: ...", "rays has ...".
std::string_view field_of(std::string_view message) {
    const auto belongs = [](char c) {
        return std::islower(static_cast<unsigned char>(c)) != 0 ||
               std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' ||
               c == '[' || c == ']';
    };
    const auto end =
        static_cast<std::size_t>(std::ranges::find_if_not(message, belongs) - message.begin());
    const std::string_view rest = message.substr(end);
    const bool is_field = end > 0 && (rest.starts_with(": ") || rest.starts_with(" is ") ||
                                      rest.starts_with(" has "));
    return is_field ? message.substr(0, end) : std::string_view{};
}

}  // namespace

grpc::Status to_rich_status(const Status& status) {
    const grpc::Status plain = to_grpc(status);
    if (status.ok()) return plain;
    const Error& error = status.error();
    google::rpc::Status rich;
    rich.set_code(plain.error_code());
    rich.set_message(error.message);
    google::rpc::ErrorInfo info;
    info.set_reason(std::string(reason_of(error.code)));
    info.set_domain("jostle");
    rich.add_details()->PackFrom(info);
    if (error.code == ErrorCode::resource_exhausted || error.code == ErrorCode::unavailable) {
        const int ms = error.retry_after_ms > 0               ? error.retry_after_ms
                       : error.code == ErrorCode::unavailable ? retry_elsewhere_ms
                                                              : retry_ms;
        google::rpc::RetryInfo retry;
        retry.mutable_retry_delay()->set_seconds(ms / 1000);
        retry.mutable_retry_delay()->set_nanos(ms % 1000 * 1'000'000);
        rich.add_details()->PackFrom(retry);
    }
    if (const auto field = field_of(error.message);
        !field.empty() && error.code == ErrorCode::invalid_argument) {
        google::rpc::BadRequest wrong;
        wrong.add_field_violations()->set_field(std::string(field));
        wrong.mutable_field_violations(0)->set_description(error.message);
        rich.add_details()->PackFrom(wrong);
    }
    return {plain.error_code(), plain.error_message(), rich.SerializeAsString()};
}

}  // namespace jostle::server
