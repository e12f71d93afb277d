// SPDX-License-Identifier: MIT
#include "bench/accuracy/flag_selection.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "bench/accuracy/accuracy_engine_kinds.h"
#include "bench/accuracy/experiment_list.h"
#include "bench/accuracy/reference.h"
#include "bench/accuracy/row_family.h"
#include "bench/measure.h"
#include "jostle/base/nearest_name.h"

namespace jostle::bench::accuracy {
namespace {

std::vector<std::string> missing_peers() {
    std::vector<std::string> absent;
    for (const EngineKind& kind : engine_kinds())
        if (!kind.make) absent.push_back(kind.name);
    return absent;
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
    return text;
}

}  // namespace

bool contains(const std::vector<std::string>& list, const std::string& name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

std::string check_experiment(const std::string& name) {
    std::vector<std::string> known = {"all", "none", "fixed", "families"};
    if (contains(known, name) || find_experiment(name) || find_family(name)) return "";
    for (const Experiment& experiment : all_experiments())
        if (experiment.family.empty()) known.push_back(experiment.name);
    for (const RowFamily& family : all_families()) known.push_back(family.name);
    return "unknown scene " + name + did_you_mean(name, known) + "; must be one of " +
           joined(known);
}

std::string check_peer(const std::string& name) {
    if (name == "all" || name == "none") return "";
    const EngineKind* kind = find_engine_kind(name);
    if (!kind || kind == &engine_kinds()[0]) {
        std::vector<std::string> known = {"all", "none"};
        for (const EngineKind& peer : engine_kinds().subspan(1)) known.push_back(peer.name);
        return "unknown peer " + name + "; must be one of " + joined(known);
    }
    if (kind->make) return "";
    return name + " is not built in: install its library (scripts/setup --with-peers), then run " +
           "cmake and build again";
}

std::string check_mode(const std::string& name) {
    if (name == "all" || name == "default") return "";
    std::vector<std::string> known = {"all", "default"};
    for (const EngineKind& kind : engine_kinds()) {
        if (contains(kind.modes, name)) return "";
        known.insert(known.end(), kind.modes.begin(), kind.modes.end());
    }
    return "unknown mode " + name + "; must be one of " + joined(known);
}

std::string check_rate(const std::string& text) {
    char* end = nullptr;
    const long rate = std::strtol(text.c_str(), &end, 10);
    if (*end == 0 && rate >= 4 && rate <= reference_hz && reference_hz % rate == 0) return "";
    return text + " is not a valid rate; must be an integer of at least 4 Hz that divides " +
           std::to_string(reference_hz);
}

std::vector<const Experiment*> selected_experiments(const std::vector<std::string>& chosen) {
    std::vector<const Experiment*> experiments;
    for (const Experiment& experiment : all_experiments())
        if (contains(chosen, "all") || contains(chosen, experiment.name) ||
            contains(chosen, experiment.family.empty() ? "fixed" : "families") ||
            contains(chosen, experiment.family))
            experiments.push_back(&experiment);
    return experiments;
}

std::vector<const Experiment*> drawn_experiments(const std::vector<std::string>& chosen, int count,
                                                 std::uint64_t seed) {
    std::vector<const Experiment*> experiments;
    for (const RowFamily& family : all_families())
        if (contains(chosen, "all") || contains(chosen, "families") ||
            contains(chosen, family.name))
            for (Experiment& member : drawn_members(family, count, seed))
                experiments.push_back(add_experiment(std::move(member)));
    return experiments;
}

std::vector<const EngineKind*> selected_engines(const std::vector<std::string>& peers) {
    std::vector<const EngineKind*> chosen;
    for (const EngineKind& kind : engine_kinds())
        if (chosen.empty() || (kind.make && (contains(peers, "all") || contains(peers, kind.name))))
            chosen.push_back(&kind);
    return chosen;
}

std::vector<std::string> selected_modes(const EngineKind& kind,
                                        const std::vector<std::string>& chosen) {
    if (contains(chosen, "all")) return kind.modes;
    std::vector<std::string> modes;
    for (const std::string& mode : kind.modes)
        if (contains(chosen, mode) || (contains(chosen, "default") && mode == kind.modes[0]))
            modes.push_back(mode);
    return modes;
}

std::string engine_list() {
    std::string text = "Engines and their modes, the default one first:\n";
    for (const EngineKind& kind : engine_kinds())
        text += std::string("  ") + kind.name + (kind.make ? "" : " (not built in)") + ": " +
                kind.about + "\n    " + joined(kind.modes) + "\n";
    return text;
}

std::string experiment_list() {
    std::string text = "Scenes and their two errors:\n";
    for (const Experiment& experiment : all_experiments())
        if (experiment.family.empty())
            text += "  " + experiment.name + ": " + experiment.about + "\n    " +
                    experiment.measures + "\n";
    return text;
}

std::string family_list() {
    std::string text = "Families, their two errors and their parameters:\n";
    for (const RowFamily& family : all_families()) {
        std::vector<std::string> names;
        for (const Parameter& parameter : family.parameters)
            names.push_back(parameter.name.substr(0, parameter.name.find(',')));
        text += "  " + family.name + ": " + family.about + "\n    " + family.measures + "\n    " +
                joined(names) + "\n";
    }
    return text;
}

void print_missing_peers() {
    for (const std::string& peer : missing_peers())
        std::fprintf(stderr, "jostle-bench: %s is not built in\n", peer.c_str());
}

nlohmann::ordered_json result_header(const char* benchmark) {
    return {{"benchmark", benchmark},
            {"cpu", cpu_model()},
            {"compiler", compiler()},
            {"peers_not_built_in", missing_peers()}};
}

}  // namespace jostle::bench::accuracy
