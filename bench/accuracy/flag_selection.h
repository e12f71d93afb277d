// SPDX-License-Identifier: MIT
//
// What the flags of jostle-bench accuracy and stability name. A check returns nothing when the name
// is right, else what is wrong: what CLI11 asks of a validator.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/accuracy/experiment.h"

namespace jostle::bench::accuracy {

bool names(const std::vector<std::string>& list, const std::string& name);

std::string check_experiment(const std::string& name);
std::string check_peer(const std::string& name);
std::string check_mode(const std::string& name);
std::string check_rate(const std::string& text);  // must divide the reference's rate

std::vector<const Experiment*> chosen_experiments(const std::vector<std::string>& chosen);
// Jostle and the peers that are chosen and built in.
std::vector<const EngineKind*> chosen_engines(const std::vector<std::string>& peers);
// Of the engine: all, its default, or those that are named.
std::vector<std::string> chosen_modes(const EngineKind& kind,
                                      const std::vector<std::string>& chosen);

std::string lists_of_engines();      // for --help
std::string lists_of_experiments();  // for --help
void say_which_are_absent();         // peers that are not built in, on stderr
nlohmann::ordered_json file_head(const char* benchmark);

}  // namespace jostle::bench::accuracy
