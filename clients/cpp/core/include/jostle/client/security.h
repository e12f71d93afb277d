// SPDX-License-Identifier: MIT
//
// How a client reaches a server that wants TLS and tokens. The default is neither, which a server
// takes only on its own machine.
#pragma once

#include <string>

#include "jostle/base/result.h"

namespace jostle::client {

struct Security {
    bool tls = false;
    std::string root_certificates_pem;     // whose certificates the server may show; empty: the
                                           // system's authorities
    std::string certificate_pem, key_pem;  // shown to the server; empty: none
    std::string token;                     // sent with each call; empty: none
};

// Paths, as flags name them; empty: not given.
struct SecurityFiles {
    bool tls = false;  // a CA or a certificate means it, too
    std::string root_certificates, certificate, key, token;
};

// Reads them. An error names the file and what to do. A token goes out only encrypted, or to this
// machine: `target` says which of the two.
Result<Security> read_security(const SecurityFiles& files, const std::string& target);

}  // namespace jostle::client
