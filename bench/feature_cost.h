// SPDX-License-Identifier: MIT
//
// jostle-bench features: the cost of a feature in a world that does not use it.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

// Adds the subcommand; running it sets the exit status of the program.
void add_features(CLI::App& app, int& status);

}  // namespace jostle::bench
