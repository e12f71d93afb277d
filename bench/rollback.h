// SPDX-License-Identifier: MIT
//
// jostle-bench rollback: what it costs to keep a moment of a world and to go back to it.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

// Adds the subcommand; running it sets the status that the program ends with.
void add_rollback(CLI::App& app, int& status);

}  // namespace jostle::bench
