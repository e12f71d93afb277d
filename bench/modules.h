// SPDX-License-Identifier: MIT
//
// jostle-bench modules: what a step costs with many objects of a module.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

// Adds the subcommand; running it sets the status that the program ends with.
void add_modules(CLI::App& app, int& status);

}  // namespace jostle::bench
