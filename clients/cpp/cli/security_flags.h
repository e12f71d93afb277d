// SPDX-License-Identifier: MIT
//
// The flags by which all programs say how they reach a server.
#pragma once

#include <CLI/CLI.hpp>

#include "jostle/client/security.h"

namespace jostle::client {

inline void add_security_flags(CLI::App& app, SecurityFiles& files) {
    app.add_flag("--tls", files.tls, "Speaks TLS; the system's authorities are believed");
    app.add_option("--ca", files.root_certificates,
                   "Speaks TLS; the authorities in this PEM file are believed");
    app.add_option("--cert", files.certificate, "PEM file of an own certificate to show");
    app.add_option("--key", files.key, "PEM file of its private key");
    app.add_option("--token-file", files.token, "File with the token to show");
}

}  // namespace jostle::client
