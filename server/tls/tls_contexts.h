// SPDX-License-Identifier: MIT
//
// The certificates in force as listeners take them: made anew when they change, so that each new
// connection gets the present ones and those that run keep theirs. One thread: the listener's.
#pragma once

#include <boost/asio/ssl/context.hpp>
#include <memory>

#include "server/tls/certificate_store.h"

namespace jostle::server {

class TlsContexts {
public:
    struct TlsRequirements {
        bool require_certificates = false;
        bool only_http2 = false;  // clients must offer "h2" by ALPN, as those of gRPC do
    };

    // Null: no TLS. The store outlives the contexts. With a CA for clients in it, who shows a
    // certificate must show a good one; `require_certificates`: and everybody must.
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
