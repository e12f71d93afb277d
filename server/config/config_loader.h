// SPDX-License-Identifier: MIT
//
// Loads a TOML file into a Config. Keys are the names in config.h, with a table for each inner
// struct.
#pragma once

#include <string>
#include <vector>

#include "server/config/config.h"

namespace jostle::server {

// An unknown key or a value of the wrong type is an error that names file, line and key; `config`
// is then unchanged.
Status load_config(Config& config, const std::string& path);
Status load_config_text(Config& config, const std::string& text, const std::string& name);
// Each setting is KEY=VALUE, as on a command line. A value that is not valid TOML is read as a
// string.
Status load_settings(Config& config, const std::vector<std::string>& settings);

}  // namespace jostle::server
