// SPDX-License-Identifier: MIT
#include "clients/cpp/core/src/credentials.h"

namespace jostle::client {

std::shared_ptr<grpc::ChannelCredentials> channel_credentials(const Security& security) {
    if (!security.tls) return grpc::InsecureChannelCredentials();
    grpc::SslCredentialsOptions options;
    options.pem_root_certs = security.root_certificates_pem;
    options.pem_cert_chain = security.certificate_pem;
    options.pem_private_key = security.key_pem;
    return grpc::SslCredentials(options);
}

void attach_token(grpc::ClientContext& call, const Security& security) {
    if (!security.token.empty()) call.AddMetadata("authorization", "Bearer " + security.token);
}

}  // namespace jostle::client
