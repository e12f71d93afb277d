// SPDX-License-Identifier: MIT
#include "server/grpc/caller_identity.h"

#include <string>
#include <string_view>

namespace jostle::server {

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

}  // namespace jostle::server
