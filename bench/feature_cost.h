// SPDX-License-Identifier: MIT
//
// jostle-bench features: what a feature costs a world that does not use it.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

// Adds the subcommand; running it sets the status that the program ends with.
void add_features(CLI::App& app, int& status);

}  // namespace jostle::bench
