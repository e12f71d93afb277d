// SPDX-License-Identifier: MIT
//
// jostle-bench accuracy: run time against error, scene by scene, in Jostle and other engines.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

// Adds the subcommand; running it sets the status that the program ends with.
void add_accuracy(CLI::App& app, int& status);

}  // namespace jostle::bench
