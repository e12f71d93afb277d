// SPDX-License-Identifier: MIT
//
// jostle-bench integrators: error, order and energy drift of methods that step a particle through a
// field.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

void add_integrators(CLI::App& app, int& status);  // sets the exit status when run

}  // namespace jostle::bench
