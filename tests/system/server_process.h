// SPDX-License-Identifier: MIT
//
// The jostle-server of this build as a child process.
#pragma once

#include "bench/processes/server_process.h"

namespace jostle::test {

class ServerProcess : public bench::ServerProcess {
public:
    explicit ServerProcess(std::vector<std::string> flags, bool wait_for_ports = true)
        : bench::ServerProcess(JOSTLE_SERVER, std::move(flags), wait_for_ports) {}
};

}  // namespace jostle::test
