// SPDX-License-Identifier: MIT
//
// jostle-bench network: bytes and time of snapshots of the scene katamari by codec, compared with
// the model that Fabian Giesen published for a similar data set of cubes.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

// Adds the subcommand; running it sets the exit status of the program.
void add_network(CLI::App& app, int& status);

}  // namespace jostle::bench
