// SPDX-License-Identifier: MIT
//
// CPU time of a server on this machine.
#pragma once

#include <optional>
#include <string>

namespace jostle::load {

// Returns the process that listens on the port of HOST:PORT if HOST is this machine.
std::optional<int> find_listener(const std::string& target);
// CPU time of the process so far, s.
std::optional<double> cpu_seconds(int pid);

}  // namespace jostle::load
