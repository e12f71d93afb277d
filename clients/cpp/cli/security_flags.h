// SPDX-License-Identifier: MIT
//
// Command-line flags for TLS and tokens, shared by all client programs.
#pragma once

#include <CLI/CLI.hpp>

#include "jostle/client/security.h"

namespace jostle::client {

inline void add_security_flags(CLI::App& app, SecurityFiles& files) {
    app.add_flag("--tls", files.tls, "Use TLS and verify the server with the system's CAs")
        ->group("Security");
    app.add_option("--ca", files.root_certificates,
                   "Use TLS and verify the server with the CAs in a PEM file")
        ->type_name("FILE")
        ->group("Security");
    app.add_option("--cert", files.certificate, "Present the client certificate in a PEM file")
        ->type_name("FILE")
        ->group("Security");
    app.add_option("--key", files.key, "Read the private key of --cert from a PEM file")
        ->type_name("FILE")
        ->group("Security");
    app.add_option("--token-file", files.token, "Send the bearer token in FILE")
        ->type_name("FILE")
        ->group("Security");
}

}  // namespace jostle::client
