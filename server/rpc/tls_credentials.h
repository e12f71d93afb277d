// SPDX-License-Identifier: MIT
//
// The certificates in force as gRPC takes them: it watches the files that the store publishes.
#pragma once

#include <grpcpp/security/server_credentials.h>

#include <memory>

#include "tls/certificate_store.h"

namespace jostle::server {

// Null: without TLS. With a CA for clients in the store, who shows a certificate must show a good
// one.
std::shared_ptr<grpc::ServerCredentials> server_credentials(const CertificateStore* store);

}  // namespace jostle::server
