// SPDX-License-Identifier: MIT
//
// jostle-bench rollback: the cost of capturing the state of a world and restoring it.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

// Adds the subcommand; running it sets the exit status of the program.
void add_rollback(CLI::App& app, int& status);

}  // namespace jostle::bench
