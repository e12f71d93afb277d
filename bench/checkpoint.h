// SPDX-License-Identifier: MIT
//
// jostle-bench checkpoint: what it costs to keep a running world on the disk.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

// Adds the subcommand; running it sets the status that the program ends with.
void add_checkpoint(CLI::App& app, int& status);

}  // namespace jostle::bench
