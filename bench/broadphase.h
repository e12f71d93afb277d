// SPDX-License-Identifier: MIT
//
// jostle-bench broadphase: runs the same workload on all broad phases.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

// Adds the subcommand; running it sets the exit status of the program.
void add_broadphase(CLI::App& app, int& status);

}  // namespace jostle::bench
