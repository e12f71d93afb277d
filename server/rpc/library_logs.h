// SPDX-License-Identifier: MIT
//
// What gRPC and protobuf have to say goes to our log, which is bounded and never waits, and not to
// standard error: strangers can make them say a lot.
#pragma once

namespace jostle::server {

// Any number of times; for the whole process.
void send_library_logs_to_ours();

}  // namespace jostle::server
