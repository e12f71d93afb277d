// SPDX-License-Identifier: MIT
//
// What gRPC has to say goes to our log, which is bounded and never waits, and not to standard
// error.
#pragma once

namespace jostle::server {

// Any number of times; for the whole process.
void send_grpc_log_to_ours();

}  // namespace jostle::server
