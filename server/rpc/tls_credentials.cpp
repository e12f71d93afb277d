// SPDX-License-Identifier: MIT
#include "rpc/tls_credentials.h"

#include <grpcpp/security/tls_certificate_provider.h>
#include <grpcpp/security/tls_credentials_options.h>

namespace jostle::server {

namespace {

constexpr unsigned refresh_seconds = 1;  // the least that gRPC allows

}  // namespace

std::shared_ptr<grpc::ServerCredentials> server_credentials(const CertificateStore* store) {
    if (!store) return grpc::InsecureServerCredentials();
    const std::string identity = store->identity_file(), clients = store->client_ca_file();
    const auto provider = std::make_shared<grpc::experimental::FileWatcherCertificateProvider>(
        identity, identity, clients, refresh_seconds);
    grpc::experimental::TlsServerCredentialsOptions options(provider);
    options.watch_identity_key_cert_pairs();
    if (!clients.empty()) {
        options.watch_root_certs();
        options.set_cert_request_type(GRPC_SSL_REQUEST_CLIENT_CERTIFICATE_AND_VERIFY);
    }
    return grpc::experimental::TlsServerCredentials(options);
}

}  // namespace jostle::server
