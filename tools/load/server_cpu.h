// SPDX-License-Identifier: MIT
//
// The processor time of the server, when it runs on this machine.
#pragma once

#include <optional>
#include <string>

namespace jostle::load {

// The process that listens on the port of HOST:PORT, when HOST is this machine.
std::optional<int> find_listener(const std::string& target);
// Seconds of processor time that the process has used so far.
std::optional<double> cpu_seconds(int pid);

}  // namespace jostle::load
