// SPDX-License-Identifier: MIT
//
// Identity of the peer of a TLS connection, from its certificate.
#pragma once

#include <openssl/ssl.h>

#include <string>

namespace jostle::server {

// The subject, such as "CN=ops,O=Example" (RFC 2253), if TLS has verified it; empty: no
// certificate.
std::string verified_subject(const SSL* connection);

}  // namespace jostle::server
