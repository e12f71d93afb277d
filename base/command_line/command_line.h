// SPDX-License-Identifier: MIT
//
// Parses the command line of a program: --version, exit statuses, and errors that suggest the
// nearest flag or subcommand. Included by the main source of each program only, because CLI11 is
// slow to compile.
#pragma once

#include <CLI/CLI.hpp>

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "jostle/base/nearest_name.h"

namespace jostle {

struct Program {
    std::string name, version;  // JOSTLE_VERSION, which jostle_program() of CMake defines
};

// The subcommand that the arguments have selected so far.
inline const CLI::App& innermost_command(const CLI::App& app) {
    const CLI::App* command = &app;
    while (!command->get_subcommands().empty()) command = command->get_subcommands().front();
    return *command;
}

// Describes the first argument that the command does not accept.
inline std::string unknown_argument(const CLI::App& command, const std::string& argument) {
    std::vector<std::string> names;
    if (argument.starts_with("-")) {
        const std::string flag = argument.substr(0, argument.find('='));
        for (const CLI::App* app = &command; app != nullptr; app = app->get_parent()) {
            for (const CLI::Option* option : app->get_options()) {
                for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
            }
        }
        return "unknown flag \"" + flag + "\"" + did_you_mean(flag, names);
    }
    for (const CLI::App* sub : command.get_subcommands([](const CLI::App*) { return true; }))
        if (!sub->get_name().empty()) names.push_back(sub->get_name());
    if (names.empty()) return "unexpected argument \"" + argument + "\"";
    const std::string suggestion = did_you_mean(argument, names);
    if (!suggestion.empty()) return "unknown command \"" + argument + "\"" + suggestion;
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
    return "unknown command \"" + argument + "\"; must be one of " + all;
}

// Returns the exit status if the program has to end: 0 after --help and --version, 2 for a wrong
// command line.
inline std::optional<int> parse_command_line(CLI::App& app, const Program& program, int argc,
                                             char** argv) {
    app.set_version_flag("--version", program.name + " " + program.version,
                         "Print the version and exit");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        const std::vector<std::string> left = app.remaining(true);
        if (error.get_exit_code() == 0 || left.empty()) return app.exit(error) == 0 ? 0 : 2;
        std::string path = program.name;
        const CLI::App& command = innermost_command(app);
        for (const CLI::App* at = &app; at != &command; path += " " + at->get_name())
            at = at->get_subcommands().front();
        std::fprintf(stderr, "%s: %s\nRun with --help for more information.\n", path.c_str(),
                     unknown_argument(command, left.front()).c_str());
        return 2;
    }
    return std::nullopt;
}

}  // namespace jostle
