// SPDX-License-Identifier: MIT
//
// Ends the process with a message and status 1 if memory or threads run out while the server
// starts. The failure may occur on any thread and in any library, as an exception or as abort(), so
// the process cannot unwind; it has no clients yet. For the program only, not for servers within
// other programs.
#pragma once

#include <string>

namespace jostle::server {

// Why an allocation or a thread failed, with the limits that are set: "out of memory: the address
// space is limited to 200000 kB (RLIMIT_AS, ulimit -v); raise or remove the limit".
std::string out_of_memory_text();
std::string out_of_threads_text();

// Call it first in main().
void begin_start_guard();
// The server has started: failures have their usual effect again.
void end_start_guard();

}  // namespace jostle::server
