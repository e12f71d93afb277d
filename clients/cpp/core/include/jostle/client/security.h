// SPDX-License-Identifier: MIT
//
// TLS and tokens of a client. The default is neither, which servers accept only on loopback.
#pragma once

#include <string>

#include "jostle/base/result.h"

namespace jostle::client {

/// Security settings of a connection.
struct Security {
    bool tls = false;
    /// CA certificates that verify the server; empty: the system's CAs
    std::string root_certificates_pem;
    std::string certificate_pem, key_pem;  ///< client certificate and key; empty: none
    std::string token;                     ///< bearer token, sent with each call; empty: none
};

/// File paths, as on the command line; empty: not given.
struct SecurityFiles {
    bool tls = false;  ///< implied by a CA or a certificate
    std::string root_certificates, certificate, key, token;
};

/// Reads the files. Errors name the file and the remedy. A token is sent only over TLS or to a
/// loopback address, which `target` determines.
Result<Security> read_security(const SecurityFiles& files, const std::string& target);

}  // namespace jostle::client
