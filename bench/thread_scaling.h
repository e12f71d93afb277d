// SPDX-License-Identifier: MIT
//
// jostle-bench threads: the effect of more threads on the step times of the scenes of 'speed'.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

// Adds the subcommand; running it sets the exit status of the program.
void add_threads(CLI::App& app, int& status);

}  // namespace jostle::bench
