// SPDX-License-Identifier: MIT
//
// jostle-bench integrators: error, order and energy of ways to step a particle through a field.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

void add_integrators(CLI::App& app, int& status);  // the exit status is left in `status`

}  // namespace jostle::bench
