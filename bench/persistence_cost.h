// SPDX-License-Identifier: MIT
//
// jostle-bench persistence: the cost of storing a world outside its process and loading it.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

// Adds the subcommand; running it sets the exit status of the program.
void add_persistence(CLI::App& app, int& status);

}  // namespace jostle::bench
