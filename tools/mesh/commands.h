// SPDX-License-Identifier: MIT
//
// The subcommands of jostle-mesh. Each adds its flags to the program; its callback runs it and
// stores the exit status.
#pragma once

#include <CLI/CLI.hpp>

namespace jostle::mesh {

void add_decompose(CLI::App& app, int& status);
void add_fracture(CLI::App& app, int& status);

}  // namespace jostle::mesh
