// SPDX-License-Identifier: MIT
#include "server/app/shutdown.h"

#include <cstdlib>

#include "server/util/log.h"

namespace jostle::server {

ShutdownWatchdog::ShutdownWatchdog(Clock::duration timeout)
    : thread_([this, timeout] {
          std::unique_lock lock(mutex_);
          if (ended_.wait_for(lock, timeout, [this] { return done_; })) return;
          log_error("shutdown took longer than {} ms; exit with status {}",
                    std::chrono::duration_cast<std::chrono::milliseconds>(timeout).count(),
                    exit_status);
          stop_log();
          std::_Exit(exit_status);
      }) {}

ShutdownWatchdog::~ShutdownWatchdog() {
    {
        const std::lock_guard lock(mutex_);
        done_ = true;
    }
    ended_.notify_all();
    thread_.join();
}

}  // namespace jostle::server
