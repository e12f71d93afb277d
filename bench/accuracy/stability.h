// SPDX-License-Identifier: MIT
//
// jostle-bench stability: stress tests of Jostle and other engines.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

// Adds the subcommand; running it sets the exit status of the program.
void add_stability(CLI::App& app, int& status);

}  // namespace jostle::bench
