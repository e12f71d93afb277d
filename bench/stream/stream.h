// SPDX-License-Identifier: MIT
//
// jostle-bench stream: the cost of a message to a client in jostle-server, compared with minimal
// servers that only send.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

void add_stream(CLI::App& app, int& status);  // sets the exit status when run

}  // namespace jostle::bench
