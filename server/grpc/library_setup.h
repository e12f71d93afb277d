// SPDX-License-Identifier: MIT
//
// Configures the libraries below gRPC for this process. Messages of gRPC and protobuf go to the
// server log, which is bounded and never blocks, instead of standard error: clients can cause many
// of them. Abseil's deadlock detection is disabled: it is on by default in builds with assertions,
// takes a tenth of the time of each message, and finds only what tests should find.
#pragma once

namespace jostle::server {

// Applies to the entire process; can be called repeatedly.
void configure_libraries();

}  // namespace jostle::server
