// SPDX-License-Identifier: MIT
//
// jostle-bench speed: time and error of Jostle and other engines on the same scenes.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

// Adds the subcommand; running it sets the exit status of the program.
void add_speed(CLI::App& app, int& status);

}  // namespace jostle::bench
