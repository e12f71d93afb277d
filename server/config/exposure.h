// SPDX-License-Identifier: MIT
//
// Who can reach this server, by its settings alone, and what follows from it. Asked once, before
// anything listens.
#pragma once

#include "server/config/config.h"

namespace jostle::server {

// "localhost", 127.0.0.0/8, ::1. Any other name counts as one that strangers can reach.
bool is_loopback(const std::string& host);

// Refuses to listen beyond loopback without both TLS and tokens, unless `insecure` is set.
Status check_exposure(const Config& config);

// What those may do who show neither a token nor a certificate: auth.anonymous_role. Without it:
// nothing once there are keys for tokens; before that everything on loopback, where only people of
// this machine come from, and what a director may do elsewhere.
std::string anonymous_role(const Config& config);

}  // namespace jostle::server
