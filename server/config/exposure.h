// SPDX-License-Identifier: MIT
//
// Reachability of this server according to its settings, and the consequences. Evaluated once,
// before the server listens.
#pragma once

#include "server/config/config.h"

namespace jostle::server {

// True for "localhost", 127.0.0.0/8 and ::1. Any other name counts as reachable from other
// machines.
bool is_loopback(const std::string& host);

// Rejects listeners beyond loopback without both TLS and tokens, unless `insecure` is set. Also
// rejects trusted proxies in front of loopback listeners without tokens and without a role for
// anonymous clients, because such a proxy connects other machines; it may terminate TLS itself.
Status check_exposure(const Config& config);

// Role of a client without token and certificate: auth.anonymous_role. If it is empty, the role is
// "none" once auth.keys is set, else "admin" on loopback without trusted proxies, where all clients
// are on this machine, and "director" otherwise.
std::string anonymous_role(const Config& config);

}  // namespace jostle::server
