// SPDX-License-Identifier: MIT
//
// jostle-bench stability: scenes in which engines fail, and whether they do.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

// Adds the subcommand; running it sets the status that the program ends with.
void add_stability(CLI::App& app, int& status);

}  // namespace jostle::bench
