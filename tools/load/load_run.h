// SPDX-License-Identifier: MIT
//
// One run from the first client that joins to the report: the ramp, a while to settle, the
// measurement.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>

#include "tools/load/client_pool.h"
#include "tools/load/load_options.h"
#include "tools/load/report.h"

namespace jostle::load {

// Measures from when all have joined and `settle` has passed; when some do not join within ten
// seconds after the ramp, without them. Ends early when `stop` becomes true. `server_pid`: whose
// processor time to read; nothing: of nobody. `before_end` is called when the measurement is over
// and the clients are still there. Tells how it goes on a terminal.
Report run_load(const LoadOptions& plan, ClientPool& pool, std::optional<int> server_pid,
                const std::atomic<bool>& stop, const std::function<void()>& before_end = {});

// One socket a client, and some: as many as the system lets this process have. False: it may not
// have so many.
bool raise_socket_limit(int clients);

}  // namespace jostle::load
