// SPDX-License-Identifier: MIT
//
// The bound ports of a server, and the file in which scripts and tests find them. Any thread.
#pragma once

#include <string>

#include "jostle/base/result.h"

namespace jostle::server {

struct Ports {
    int grpc = 0, http = 0;
    int admin = 0, datagrams = 0;  // 0: not listening
};

// Writes {"grpc": N, "http": N, ...} to the path; an empty path does nothing. A reader never sees a
// partial file. Errors: the file cannot be written.
Status write_port_file(const std::string& path, const Ports& ports);

}  // namespace jostle::server
