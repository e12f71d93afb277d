// SPDX-License-Identifier: MIT
#include "rpc/caller_identity.h"

#include <string>
#include <string_view>

#include "base/address.h"

namespace jostle::server {

namespace {

std::string_view header_of(const grpc::ServerContext& call, const char* name) {
    const auto& headers = call.client_metadata();
    const auto at = headers.find(name);
    if (at == headers.end()) return {};
    return {at->second.data(), at->second.size()};
}

// Empty unless TLS has verified it.
std::string certificate_of(const grpc::ServerContext& call) {
    const auto context = call.auth_context();
    if (!context || !context->IsPeerAuthenticated()) return {};
    for (const char* name : {"x509_subject", "x509_common_name"})
        for (const grpc::string_ref& value : context->FindPropertyValues(name))
            return {value.data(), value.size()};
    return {};
}

}  // namespace

Result<Identity> identify(const grpc::ServerContext& call, Gate& gate) {
    const Result<std::string_view> bearer = bearer_in(header_of(call, "authorization"));
    if (!bearer.ok()) return bearer.error();
    const std::string certificate = certificate_of(call),
                      address = address_of_grpc_peer(call.peer());
    return gate.identify({.bearer = *bearer, .certificate = certificate, .address = address});
}

}  // namespace jostle::server
