// SPDX-License-Identifier: MIT
//
// Writes the golden hashes of this build, or compares them with those of a file. It needs neither a
// test library, which some target machines lack, nor file streams, which the WebAssembly library
// lacks (scripts/determinism-check).
#include <cstdlib>
#include <memory>
#include <optional>

#include "tests/determinism/golden_hashes.h"

namespace jostle::test {
namespace {

constexpr const char* usage = R"(golden_hashes [FILE]
    Write the golden hashes of this build to FILE [default: the file that the tests read].
golden_hashes --check FILE [--scenes NAME,NAME...] [--steps N] [--configurations N]
    Compare with FILE and print the first line that differs.
    --scenes NAME,NAME...  scenes [default: all]
    --steps N              number of steps [default: 400; 0 to 400]
    --configurations N     number of configurations: 1 to 8 threads, each with the next
                           instruction set [default: 1; 1 to 8]
)";

struct Options {
    std::string file = GOLDEN_HASHES;
    bool check = false;
    std::vector<std::string> scenes;
    int steps = golden_steps;
    int configurations = 1;
};

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == separator)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

std::string scene_names() {
    std::string names;
    for (const TestScene& scene : test_scenes()) names += (names.empty() ? "" : ", ") + scene.name;
    return names;
}

bool is_scene(const std::string& name) {
    for (const TestScene& scene : test_scenes())
        if (scene.name == name) return true;
    return false;
}

// Returns nothing and prints an error if the arguments are invalid.
std::optional<Options> read_options(int argc, char** argv) {
    const auto refuse = [](const std::string& why) -> std::optional<Options> {
        std::fprintf(stderr, "golden_hashes: %s\n%s", why.c_str(), usage);
        return std::nullopt;
    };
    Options options;
    if (argc == 2 && argv[1][0] != '-') options.file = argv[1];
    if (argc < 2 || argv[1][0] != '-')
        return argc > 2 ? refuse("more than one FILE; at most one is accepted") : options;
    for (int i = 1; i < argc; i += 2) {
        const std::string name = argv[i];
        if (i + 1 == argc) return refuse(name + " is not an option with a value");
        const std::string value = argv[i + 1];
        if (name == "--check") {
            options.check = true;
            options.file = value;
        } else if (name == "--scenes") {
            options.scenes = split(value, ',');
            for (const std::string& scene : options.scenes)
                if (!is_scene(scene))
                    return refuse("unknown scene '" + scene + "'; accepted are " + scene_names());
        } else if (name == "--steps") {
            options.steps = std::atoi(value.c_str());
            if (options.steps < 0 || options.steps > golden_steps)
                return refuse("--steps is " + value + "; it must be from 0 to " +
                              std::to_string(golden_steps));
        } else if (name == "--configurations") {
            options.configurations = std::atoi(value.c_str());
            if (options.configurations < 1 || options.configurations > 8)
                return refuse("--configurations is " + value + "; it must be from 1 to 8");
        } else {
            return refuse("unknown option " + name);
        }
    }
    if (!options.check)
        return refuse("--scenes, --steps and --configurations require --check FILE");
    return options;
}

struct NumberedLine {
    int number;
    std::string text;
};

using File = std::unique_ptr<std::FILE, decltype([](std::FILE* file) { std::fclose(file); })>;

std::string read_all(std::FILE* file) {
    std::string text;
    char part[4096];
    while (const std::size_t count = std::fread(part, 1, sizeof part, file))
        text.append(part, count);
    return text;
}

// The lines of the file, "scene step hash", that the options select.
std::vector<NumberedLine> expected_lines(const std::string& text, const Options& options) {
    std::vector<NumberedLine> selected;
    int number = 0;
    for (const std::string& line : split(text, '\n')) {
        number++;
        if (line.empty()) continue;
        const std::vector<std::string> words = split(line, ' ');
        const auto& names = options.scenes;
        const bool named =
            names.empty() || std::find(names.begin(), names.end(), words[0]) != names.end();
        const bool early = words.size() < 2 || std::atoi(words[1].c_str()) <= options.steps;
        if (named && early) selected.push_back({number, line});
    }
    return selected;
}

int check(const Options& options) {
    const File file(std::fopen(options.file.c_str(), "rb"));
    if (!file) {
        std::fprintf(stderr, "golden_hashes: cannot read %s\n", options.file.c_str());
        return 1;
    }
    const std::vector<NumberedLine> golden = expected_lines(read_all(file.get()), options);
    std::string configurations;
    for (const GoldenConfiguration& configuration : golden_configurations(options.configurations)) {
        must(physics::use_instruction_set(configuration.set));
        const std::vector<std::string> here =
            golden_lines(configuration.threads, options.scenes, options.steps);
        for (std::size_t i = 0; i < std::max(here.size(), golden.size()); i++) {
            const std::string other = i < here.size() ? here[i] : "nothing";
            if (i < golden.size() && other == golden[i].text) continue;
            std::fprintf(stderr, "golden_hashes: %s: line %d is '%s', this build has '%s' (%s)\n",
                         options.file.c_str(), i < golden.size() ? golden[i].number : 0,
                         i < golden.size() ? golden[i].text.c_str() : "missing", other.c_str(),
                         to_string(configuration).c_str());
            return 1;
        }
        configurations += (configurations.empty() ? "" : "; ") + to_string(configuration);
    }
    std::printf("%zu hashes equal (%s)\n", golden.size(), configurations.c_str());
    return 0;
}

int write(const std::string& path) {
    std::string text;
    for (const std::string& line : golden_lines()) text += line + "\n";
    const File file(std::fopen(path.c_str(), "wb"));
    if (!file || std::fputs(text.c_str(), file.get()) < 0 || std::fflush(file.get()) != 0) {
        std::fprintf(stderr, "cannot write %s; check that its folder exists and is writable\n",
                     path.c_str());
        return 1;
    }
    std::printf("%swritten to %s\n", text.c_str(), path.c_str());
    return 0;
}

}  // namespace
}  // namespace jostle::test

int main(int argc, char** argv) {
    using namespace jostle::test;
    const std::optional<Options> options = read_options(argc, argv);
    if (!options) return 2;
    return options->check ? check(*options) : write(options->file);
}
