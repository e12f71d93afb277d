// SPDX-License-Identifier: MIT
//
// jostle-bench speed: Jostle and other engines on the same scenes, time and error side by side.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

// Adds the subcommand; running it sets the status that the program ends with.
void add_speed(CLI::App& app, int& status);

}  // namespace jostle::bench
