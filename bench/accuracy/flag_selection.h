// SPDX-License-Identifier: MIT
//
// Values of the flags of jostle-bench accuracy and stability. A check returns an empty string for a
// valid value, otherwise an error message, as CLI11 expects of a validator.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/accuracy/experiment.h"

namespace jostle::bench::accuracy {

bool contains(const std::vector<std::string>& list, const std::string& name);

std::string check_experiment(const std::string& name);
std::string check_peer(const std::string& name);
std::string check_mode(const std::string& name);
std::string check_rate(const std::string& text);  // must divide the reference rate

// Scenes and families by name; all, fixed (scenes that belong to no family) or families.
std::vector<const Experiment*> selected_experiments(const std::vector<std::string>& chosen);
// `count` other members of each selected family.
std::vector<const Experiment*> drawn_experiments(const std::vector<std::string>& chosen, int count,
                                                 std::uint64_t seed);
// Jostle and the selected peers that are built in.
std::vector<const EngineKind*> selected_engines(const std::vector<std::string>& peers);
// Modes of the engine: all, its default, or the named ones.
std::vector<std::string> selected_modes(const EngineKind& kind,
                                        const std::vector<std::string>& chosen);

std::string engine_list();      // for --help
std::string experiment_list();  // for --help
std::string family_list();      // for --help
void print_missing_peers();     // peers that are not built in, on stderr
nlohmann::ordered_json result_header(const char* benchmark);

}  // namespace jostle::bench::accuracy
