// SPDX-License-Identifier: MIT
#include "server/grpc/conversions.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

#include "google/rpc/error_details.pb.h"
#include "google/rpc/status.pb.h"
#include "jostle/base/check.h"
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

namespace {

std::string_view header_of(const grpc::ServerContext& call, const char* name) {
    const auto& headers = call.client_metadata();
    const auto at = headers.find(name);
    if (at == headers.end()) return {};
    return {at->second.data(), at->second.size()};
}

}  // namespace

Result<Identity> identify(const grpc::ServerContext& call, const Connection& connection,
                          Authorizer& authorizer) {
    const Result<std::string_view> bearer = parse_bearer(header_of(call, "authorization"));
    if (!bearer.ok()) return bearer.error();
    return authorizer.identify(
        {.bearer = *bearer, .certificate = connection.certificate, .address = connection.address});
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
    if (message.cells.empty()) return grpc::ByteBuffer(slices.data(), count);
    std::vector<grpc::Slice> all(slices.begin(),
                                 slices.begin() + static_cast<std::ptrdiff_t>(count));
    for (const SharedBytes& cell : message.cells) all.push_back(share(cell));
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
