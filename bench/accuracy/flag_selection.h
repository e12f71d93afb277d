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

bool contains(const std::vector<std::string>& list, const std::string& name);

std::string check_experiment(const std::string& name);
std::string check_peer(const std::string& name);
std::string check_mode(const std::string& name);
std::string check_rate(const std::string& text);  // must divide the reference's rate

std::vector<const Experiment*> selected_experiments(const std::vector<std::string>& chosen);
// Jostle and the peers that are chosen and built in.
std::vector<const EngineKind*> selected_engines(const std::vector<std::string>& peers);
// Of the engine: all, its default, or those that are named.
std::vector<std::string> selected_modes(const EngineKind& kind,
                                        const std::vector<std::string>& chosen);

std::string engine_list();      // for --help
std::string experiment_list();  // for --help
void print_missing_peers();     // peers that are not built in, on stderr
nlohmann::ordered_json result_header(const char* benchmark);

}  // namespace jostle::bench::accuracy
