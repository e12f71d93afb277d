// SPDX-License-Identifier: MIT
//
// jostle-bench persistence: what it costs to keep a world beyond its process, and to have it back.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

// Adds the subcommand; running it sets the status that the program ends with.
void add_persistence(CLI::App& app, int& status);

}  // namespace jostle::bench
