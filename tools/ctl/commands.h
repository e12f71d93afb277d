// SPDX-License-Identifier: MIT
//
// What jostlectl can do, one function a command: asks the server and gives back what to print. An
// error of code invalid_argument that came before the server was asked is the caller's mistake;
// both kinds are told apart by Outcome.
#pragma once

#include <cstdint>
#include <string>

#include "tools/ctl/connection.h"

namespace jostle::ctl {

// All that flags can say about any command.
struct CommandArguments {
    std::string world, name, scene, file, reason;
    std::string from;  // a world of which the new one is a moment
    std::uint32_t client = 0, steps = 1;
    std::uint32_t tick = 0;  // 0: now
    double seconds = 5;
    bool json = false;
};

struct Outcome {
    std::string text;             // for standard output
    std::string error;            // for standard error; empty: it was done
    bool is_usage_error = false;  // of an error: flags or files, not the server
};

Outcome list_worlds(Connection& server, const CommandArguments& arguments);
Outcome create_world(Connection& server, const CommandArguments& arguments);
Outcome delete_world(Connection& server, const CommandArguments& arguments);
Outcome list_clients(Connection& server, const CommandArguments& arguments);
Outcome kick(Connection& server, const CommandArguments& arguments);
Outcome pause(Connection& server, const CommandArguments& arguments);
Outcome resume(Connection& server, const CommandArguments& arguments);
Outcome step(Connection& server, const CommandArguments& arguments);
Outcome export_world(Connection& server, const CommandArguments& arguments);
Outcome rewind(Connection& server, const CommandArguments& arguments);
Outcome drain(Connection& server, const CommandArguments& arguments);
Outcome profile(Connection& server, const CommandArguments& arguments);

}  // namespace jostle::ctl
