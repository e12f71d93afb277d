// SPDX-License-Identifier: MIT
//
// Work in a process of its own: the memory it takes is its own, and when it crashes the rest goes
// on.
#pragma once

#include <functional>
#include <string>

namespace jostle::bench {

struct ChildResult {
    std::string text;     // what the work returned
    std::string failure;  // what ended it instead, in words; empty when it returned
};

// Forks, runs the work in the child and waits for it. Only while this process has one thread.
ChildResult run_in_child(const std::function<std::string()>& work);

}  // namespace jostle::bench
