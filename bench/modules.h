// SPDX-License-Identifier: MIT
//
// jostle-bench modules: the cost of a step with many objects of a module.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

// Adds the subcommand; running it sets the exit status of the program.
void add_modules(CLI::App& app, int& status);

}  // namespace jostle::bench
