// SPDX-License-Identifier: MIT
//
// Reads a TOML file over a Config. Keys are the names of config.h, with a table for each inner
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
// KEY=VALUE each, as on a command line: what is no TOML value is taken as a string.
Status load_settings(Config& config, const std::vector<std::string>& settings);

}  // namespace jostle::server
