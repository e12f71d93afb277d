// SPDX-License-Identifier: MIT
//
// Who the other side of a TLS connection is, by the certificate that it has shown.
#pragma once

#include <openssl/ssl.h>

#include <string>

namespace jostle::server {

// The subject, as "CN=ops,O=Example" (RFC 2253), when TLS has verified it; empty: none was shown.
std::string verified_subject(const SSL* connection);

}  // namespace jostle::server
