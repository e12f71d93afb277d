// SPDX-License-Identifier: MIT
//
// jostle-bench stream: what a message to a client costs jostle-server, beside servers that only
// send.
#pragma once

namespace CLI {
class App;
}

namespace jostle::bench {

void add_stream(CLI::App& app, int& status);  // the exit status is left in `status`

}  // namespace jostle::bench
