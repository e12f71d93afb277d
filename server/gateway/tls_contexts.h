// SPDX-License-Identifier: MIT
//
// The certificates in force as Asio takes them: made anew when they change, so that each new
// connection gets the present ones and those that run keep theirs. On the gateway's thread.
#pragma once

#include <boost/asio/ssl/context.hpp>
#include <memory>

#include "tls/certificate_store.h"

namespace jostle::server {

class TlsContexts {
public:
    // Null: no TLS. The store outlives the contexts. With a CA for clients in it, who shows a
    // certificate must show a good one; `require_certificates`: and everybody must.
    TlsContexts(const CertificateStore* store, bool require_certificates)
        : store_(store), require_certificates_(require_certificates) {}

    // For the next connection; null: no TLS.
    std::shared_ptr<boost::asio::ssl::context> present();

private:
    const CertificateStore* store_;
    const bool require_certificates_;
    std::shared_ptr<const Material> material_;
    std::shared_ptr<boost::asio::ssl::context> context_;
};

}  // namespace jostle::server
