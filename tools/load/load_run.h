// SPDX-License-Identifier: MIT
//
// One load run: ramp-up, settling time, measurement, report.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <optional>

#include "tools/load/client_pool.h"
#include "tools/load/load_options.h"
#include "tools/load/report.h"

namespace jostle::load {

// Measures for the planned duration, once all clients have joined and `settle` has passed; clients
// that have not joined 10 s after the ramp are ignored. Ends early when `stop` becomes true.
// `server_pid`: process whose CPU time is measured; nothing: none. Calls `before_end` after the
// measurement, while the clients are still connected. Shows the progress on a terminal.
Report run_load(const LoadOptions& plan, ClientPool& pool, std::optional<int> server_pid,
                const std::atomic<bool>& stop, const std::function<void()>& before_end = {});

// Raises the limit of open files for one socket per client and a reserve. Returns false if the
// system does not allow it.
bool raise_socket_limit(int clients);

}  // namespace jostle::load
