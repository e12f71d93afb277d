// SPDX-License-Identifier: MIT
#include "server/grpc/conversions.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <numeric>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "google/rpc/error_details.pb.h"
#include "google/rpc/status.pb.h"
#include "jostle/base/check.h"
#include "jostle/grpc_status/grpc_status.h"

namespace jostle::server {

namespace {

constexpr int retry_ms = 1000;            // if a limit was reached
constexpr int retry_elsewhere_ms = 5000;  // if the server shuts down or a world is busy
// gRPC clients reject a response with more than 8 KiB of metadata.
constexpr std::size_t trailers_bytes_max = 7500;
constexpr std::size_t message_bytes_max = 4500;  // of them

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

// "line 3, column 5: " before the path of a field in a text.
std::string_view without_position(std::string_view line) {
    if (!line.starts_with("line ")) return line;
    const std::size_t end = line.find(": ");
    return end == std::string_view::npos ? line : line.substr(end + 2);
}

// Size of the message in the trailers, which encode other characters as %XX.
std::size_t encoded_size(std::string_view message) {
    return static_cast<std::size_t>(std::accumulate(
        message.begin(), message.end(), std::size_t{0},
        [](std::size_t sum, char c) { return sum + (c >= ' ' && c <= '~' && c != '%' ? 1 : 3); }));
}

// The last lines are removed from a message that does not fit into the trailers.
std::string fitting_message(std::string message) {
    if (encoded_size(message) <= message_bytes_max) return message;
    while (encoded_size(message) > message_bytes_max) {
        const std::size_t end = message.rfind('\n');
        message.resize(end == std::string::npos ? message_bytes_max / 3 : end);
    }
    // No part of a character of UTF-8, whose further bytes are 10xxxxxx.
    while (!message.empty() && (static_cast<unsigned char>(message.back()) & 0x80) != 0)
        message.pop_back();
    return message + "\nmore errors may follow";
}

// What remains in the trailers for violations. Details are sent in base64.
std::size_t violation_bytes(const Error& error, const google::rpc::Status& rich) {
    const std::size_t details_max = (trailers_bytes_max - encoded_size(error.message)) / 4 * 3;
    const std::size_t used = rich.ByteSizeLong() + 100;  // name of the type
    return details_max - std::min(details_max, used);
}

// One entry for each line of the message that is about a field, as far as they fit.
google::rpc::BadRequest violations_of(std::string_view message, std::size_t bytes_max) {
    google::rpc::BadRequest violations;
    while (!message.empty()) {
        const std::string_view line = message.substr(0, message.find('\n'));
        message.remove_prefix(std::min(message.size(), line.size() + 1));
        const std::string_view field = field_of(without_position(line));
        if (field.empty()) continue;
        google::rpc::BadRequest::FieldViolation& violation = *violations.add_field_violations();
        violation.set_field(std::string(field));
        violation.set_description(std::string(line));
        if (violations.ByteSizeLong() <= bytes_max) continue;
        violations.mutable_field_violations()->RemoveLast();
        break;
    }
    return violations;
}

}  // namespace

grpc::Status to_rich_status(const Status& status) {
    if (status.ok()) return to_grpc(status);
    Error error = status.error();
    error.message = fitting_message(std::move(error.message));
    const grpc::Status plain = to_grpc(error);
    google::rpc::Status rich;
    rich.set_code(plain.error_code());
    rich.set_message(error.message.substr(0, error.message.find('\n')));
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
    if (error.code == ErrorCode::invalid_argument)
        if (const auto wrong = violations_of(error.message, violation_bytes(error, rich));
            wrong.field_violations_size() > 0)
            rich.add_details()->PackFrom(wrong);
    return {plain.error_code(), plain.error_message(), rich.SerializeAsString()};
}

namespace {

std::string_view header_of(const grpc::ServerContext& call, const char* name) {
    const auto& headers = call.client_metadata();
    const auto at = headers.find(name);
    if (at == headers.end()) return {};
    return {at->second.data(), at->second.size()};
}

}  // namespace

std::string client_address(const grpc::ServerContext& call, const Connection& connection,
                           const ConnectionTable& connections) {
    if (!connection.is_proxy) return connection.address;
    const std::string_view name = connections.forwarded_header();
    const auto [first, last] = call.client_metadata().equal_range({name.data(), name.size()});
    std::string forwarded;
    for (auto at = first; at != last; ++at)
        forwarded.append(forwarded.empty() ? "" : ",").append(at->second.data(), at->second.size());
    return connections.client_address(connection, forwarded);
}

Result<Identity> identify(const grpc::ServerContext& call, const Connection& connection,
                          const std::string& address, Authorizer& authorizer) {
    const Result<std::string_view> bearer = parse_bearer(header_of(call, "authorization"));
    if (!bearer.ok()) return bearer.error();
    return authorizer.identify(
        {.bearer = *bearer, .certificate = connection.certificate, .address = address});
}

namespace {

// gRPC calls the deleter on the thread that releases the last reference; the count of a shared_ptr
// may be changed on any thread.
grpc::Slice share(const SharedBytes& bytes) {
    ASSERT(bytes);
    auto* const owner = new SharedBytes(bytes);
    // gRPC's interface takes void* but never writes into a slice.
    void* const data = const_cast<char*>(bytes->data());
    return grpc::Slice(
        data, bytes->size(), [](void* user) { delete static_cast<SharedBytes*>(user); }, owner);
}

}  // namespace

grpc::ByteBuffer to_byte_buffer(const OutMessage& message) {
    std::array<grpc::Slice, 2> slices;
    std::size_t count = 0;
    if (!message.header.empty()) {
        slices[count++] = grpc::Slice(message.header.data(), message.header.size());
    }
    if (message.shared && !message.shared->empty()) slices[count++] = share(message.shared);
    ASSERT(count <= slices.size());
    if (message.shared_fields.empty()) return grpc::ByteBuffer(slices.data(), count);
    std::vector<grpc::Slice> all(slices.begin(),
                                 slices.begin() + static_cast<std::ptrdiff_t>(count));
    for (const SharedBytes& field : message.shared_fields) all.push_back(share(field));
    return grpc::ByteBuffer(all.data(), all.size());
}

void copy_bytes(std::string& out, const grpc::ByteBuffer& buffer) {
    out.clear();
    grpc::Slice single;
    if (buffer.TrySingleSlice(&single).ok()) {
        out.assign(reinterpret_cast<const char*>(single.begin()), single.size());
        return;
    }
    std::vector<grpc::Slice> slices;
    if (!buffer.Dump(&slices).ok()) return;
    for (const grpc::Slice& slice : slices) {
        out.append(reinterpret_cast<const char*>(slice.begin()), slice.size());
    }
}

}  // namespace jostle::server
