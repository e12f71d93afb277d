// SPDX-License-Identifier: MIT
//
// How the libraries below gRPC behave in our process. What gRPC and protobuf have to say goes to
// our log, which is bounded and never waits, and not to standard error: strangers can make them say
// a lot. Abseil does not look for deadlocks: its search, on by default in builds with assertions,
// takes a tenth of the time of each message, and finds what tests have to find.
#pragma once

namespace jostle::server {

// Any number of times; for the whole process.
void configure_libraries();

}  // namespace jostle::server
