// SPDX-License-Identifier: MIT
//
// Runs work in a child process: its memory is measured separately, and a crash does not end the
// program.
#pragma once

#include <functional>
#include <string>

namespace jostle::bench {

struct ChildResult {
    std::string text;     // the result of the work
    std::string failure;  // why the process ended without a result; empty on success
};

// Forks, runs the work in the child and waits for it. This process must have only one thread.
ChildResult run_in_child(const std::function<std::string()>& work);

}  // namespace jostle::bench
