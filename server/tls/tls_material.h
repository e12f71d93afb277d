// SPDX-License-Identifier: MIT
//
// The TLS material of a listener, read from the operator's files and validated: the key matches the
// certificate, the chain is complete, nothing has expired. A value, immutable once shared; any
// thread.
#pragma once

#include <string>
#include <vector>

#include "server/config/config.h"
#include "server/util/wall_time.h"

namespace jostle::server {

struct TlsMaterial {
    std::string key_pem;    // PKCS #8
    std::string chain_pem;  // the server's own certificate first
    // CA of client certificates; empty: client certificates are not accepted
    std::string client_ca_pem;
    std::string subject;                // of the server's own certificate, as "CN=play.example.org"
    WallTime expires;                   // earliest expiry in the chain
    std::vector<std::string> warnings;  // valid, but not recommended
};

// An error names the file and the fault.
Result<TlsMaterial> read_tls_material(const TlsSettings& files, WallTime now);

}  // namespace jostle::server
