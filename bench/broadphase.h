// SPDX-License-Identifier: MIT
//
// jostle-bench broadphase: the three broad phases side by side, doing the same work.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

// Adds the subcommand; running it sets the status that the program ends with.
void add_broadphase(CLI::App& app, int& status);

}  // namespace jostle::bench
