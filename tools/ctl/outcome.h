// SPDX-License-Identifier: MIT
//
// Outcomes of commands: the text to print, from responses of the server, or an error of the server
// or in flags and files.
#pragma once

#include <string>
#include <utility>

#include "jostle/base/result.h"
#include "tools/ctl/command_arguments.h"
#include "tools/ctl/report.h"

namespace jostle::ctl {

struct Outcome {
    std::string text;             // for standard output
    std::string error;            // for standard error; empty: success
    bool is_usage_error = false;  // the error is in flags or files, not in the server
};

inline Outcome server_error(const Error& error) {
    return {.error = error.message};
}
inline Outcome usage_error(const Error& error) {
    return {.error = error.message, .is_usage_error = true};
}

// The sentence of `describe(response)`, or with --json the response itself.
template <class Response, class Describe>
Outcome outcome_of(const Result<Response>& response, const CommandArguments& arguments,
                   const Describe& describe) {
    if (!response.ok()) return server_error(response.error());
    return {.text = arguments.json ? json_text(*response) : describe(*response) + "\n"};
}

// The same for a sentence that does not depend on the response.
template <class Response>
Outcome to_outcome(const Result<Response>& response, const CommandArguments& arguments,
                   const std::string& sentence) {
    return outcome_of(response, arguments, [&](const Response&) { return sentence; });
}

// Puts the path of a file before each line of an error.
Error in_file(const std::string& path, const Error& error);

}  // namespace jostle::ctl
