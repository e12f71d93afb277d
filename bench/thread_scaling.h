// SPDX-License-Identifier: MIT
//
// jostle-bench threads: what more threads do for a step of the laboratory's scenes.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

// Adds the subcommand; running it sets the status that the program ends with.
void add_threads(CLI::App& app, int& status);

}  // namespace jostle::bench
