// SPDX-License-Identifier: MIT
#include "clients/bot/script.h"

#include <charconv>
#include <fstream>
#include <iterator>
#include <sstream>

#include "jostle/base/nearest_name.h"

namespace jostle::bot {
namespace {

struct BehaviourSpec {
    const char* behaviour;
    std::map<std::string, double> defaults;
};

const std::vector<BehaviourSpec>& behaviour_specs() {
    static const std::vector<BehaviourSpec> list = {
        {"wander", {{"period", 2}, {"strength", 4}}},
        {"push", {{"period", 1}, {"strength", 3}}},
        {"throw", {{"period", 2}, {"speed", 12}, {"max_bodies", 5}}},
        {"builder", {{"period", 1}, {"max_bodies", 8}, {"size", 0.3}}},
        {"drag", {{"period", 3}}},
        {"drive", {{"period", 0.2}, {"change", 20}}},
        {"walk", {{"period", 0.5}, {"change", 20}}},
        {"race", {{"period", 0.1}, {"radius", 45}, {"speed", 16}}},
        {"idle", {}},
    };
    return list;
}

const BehaviourSpec* find(const std::string& behaviour) {
    for (const BehaviourSpec& k : behaviour_specs())
        if (behaviour == k.behaviour) return &k;
    return nullptr;
}

Result<ScriptLine> parse_line(const std::string& text) {
    ScriptLine line;
    std::istringstream words(text);
    words >> line.behaviour;
    const BehaviourSpec* behaviour = find(line.behaviour);
    if (!behaviour) {
        std::string names;
        for (const BehaviourSpec& k : behaviour_specs())
            names += std::string(names.empty() ? "" : ", ") + k.behaviour;
        std::vector<std::string> known;
        for (const BehaviourSpec& k : behaviour_specs()) known.emplace_back(k.behaviour);
        return invalid_argument("unknown behaviour \"" + line.behaviour + "\"" +
                                did_you_mean(line.behaviour, known) + "; must be one of " + names);
    }
    line.values = behaviour->defaults;
    for (std::string word; words >> word;) {
        const std::size_t at = word.find('=');
        const std::string key = word.substr(0, at);
        if (at == std::string::npos)
            return invalid_argument("\"" + word + "\" is not of the form key=value");
        double value = 0;
        const char* end = word.data() + word.size();
        const auto [stop, error] = std::from_chars(word.data() + at + 1, end, value);
        if (error != std::errc{} || stop != end || !(value >= 0 && value <= 1e6))
            return invalid_argument("\"" + word +
                                    "\": the value must be a number from 0 to 1000000");
        if (key == "weight") {
            line.weight = value;
        } else if (const auto slot = line.values.find(key); slot != line.values.end()) {
            slot->second = value;
        } else {
            std::vector<std::string> keys = {"weight"};
            for (const auto& [known, ignored] : line.values) keys.push_back(known);
            return invalid_argument(line.behaviour + ": unknown key \"" + key + "\"" +
                                    did_you_mean(key, keys));
        }
    }
    if (line.values.contains("period") && line.values["period"] < 0.05)
        return invalid_argument("period must be at least 0.05 s");
    if (line.values.contains("radius") && line.values["radius"] < 4)
        return invalid_argument("radius must be at least 4 m");
    if (line.values.contains("size") && !(line.values["size"] >= 0.05 && line.values["size"] <= 2))
        return invalid_argument("size must be from 0.05 to 2 m");
    return line;
}

}  // namespace

Result<Script> parse_script(const std::string& text, const std::string& name) {
    Script script;
    std::istringstream lines(text);
    int number = 0;
    double weights = 0;
    for (std::string text_line; std::getline(lines, text_line);) {
        number++;
        text_line = text_line.substr(0, text_line.find('#'));
        if (text_line.find_first_not_of(" \t\r") == std::string::npos) continue;
        Result<ScriptLine> line = parse_line(text_line);
        if (!line.ok())
            return invalid_argument(name + ":" + std::to_string(number) + ": " +
                                    line.error().message);
        weights += line->weight;
        script.push_back(std::move(*line));
    }
    if (script.empty()) return invalid_argument(name + ": no behaviours");
    if (weights <= 0) return invalid_argument(name + ": all weights are zero");
    return script;
}

Result<Script> load_script(const std::string& path) {
    std::ifstream in(path);
    if (!in) return Error{ErrorCode::not_found, "cannot read the script " + path};
    return parse_script(std::string((std::istreambuf_iterator<char>(in)), {}), path);
}

Script default_script() {
    return *parse_script("wander weight=2\npush\nthrow\nbuilder\ndrag\n", "default");
}

Result<Script> script_or_default(const std::string& path) {
    if (path.empty()) return default_script();
    return load_script(path);
}

const ScriptLine& line_for(const Script& script, int i) {
    double weights = 0;
    for (const ScriptLine& line : script) weights += line.weight;
    // The golden ratio distributes any number of bots evenly over the weights.
    const double position = i * 0.6180339887498949;
    double left = (position - static_cast<double>(static_cast<long long>(position))) * weights;
    for (const ScriptLine& line : script) {
        if (left < line.weight) return line;
        left -= line.weight;
    }
    return script.back();
}

}  // namespace jostle::bot
