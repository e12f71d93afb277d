// SPDX-License-Identifier: MIT
//
// TLS contexts for the certificates in force. A context is rebuilt when the certificates change, so
// that new connections use the current ones and open connections keep theirs. Used by the
// listener's thread only.
#pragma once

#include <boost/asio/ssl/context.hpp>
#include <memory>

#include "server/tls/certificate_store.h"

namespace jostle::server {

class TlsContexts {
public:
    struct TlsRequirements {
        bool require_certificates = false;
        bool only_http2 = false;  // clients must offer "h2" with ALPN, as gRPC clients do
    };

    // Null: no TLS. The store outlives the contexts. If it contains a client CA, a presented client
    // certificate must be valid; with `require_certificates` every client must present one.
    TlsContexts(const CertificateStore* store, TlsRequirements requirements)
        : store_(store), requirements_(requirements) {}

    // For the next connection; null: no TLS.
    std::shared_ptr<boost::asio::ssl::context> current();

private:
    const CertificateStore* store_;
    const TlsRequirements requirements_;
    std::shared_ptr<const TlsMaterial> material_;
    std::shared_ptr<boost::asio::ssl::context> context_;
};

}  // namespace jostle::server
