// SPDX-License-Identifier: MIT
//
// What a listener needs for TLS, read from an operator's files and checked before anybody uses it:
// the key is that of the certificate, the chain links up, nothing has expired. A value, immutable
// once it is shared; any thread.
#pragma once

#include <string>
#include <vector>

#include "server/config/config.h"
#include "server/util/wall_time.h"

namespace jostle::server {

struct TlsMaterial {
    std::string key_pem;                // PKCS #8
    std::string chain_pem;              // the server's own certificate first
    std::string client_ca_pem;          // whose certificates clients may show; empty: no one's
    std::string subject;                // of the server's own certificate, as "CN=play.example.org"
    WallTime expires;                   // the first of the chain to do so
    std::vector<std::string> warnings;  // what works, but should not be so
};

// Errors name the file and what is wrong with it.
Result<TlsMaterial> read_tls_material(const TlsSettings& files, WallTime now);

}  // namespace jostle::server
