// SPDX-License-Identifier: MIT
//
// jostle-bench network: what snapshots of the scene katamari cost in bytes and time, by codec, and
// beside them the model that Fabian Giesen published for cubes like these.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

// Adds the subcommand; running it sets the status that the program ends with.
void add_network(CLI::App& app, int& status);

}  // namespace jostle::bench
