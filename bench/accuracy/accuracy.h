// SPDX-License-Identifier: MIT
//
// jostle-bench accuracy: CPU time against error, scene by scene, for Jostle and other engines.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

// Adds the subcommand; running it sets the exit status of the program.
void add_accuracy(CLI::App& app, int& status);

}  // namespace jostle::bench
