// SPDX-License-Identifier: MIT
#include "server/grpc/library_setup.h"

#include <absl/synchronization/mutex.h>
#include <google/protobuf/stubs/logging.h>
#include <grpc/support/log.h>

#include <string>

#include "server/util/log.h"
#include "server/util/text.h"

namespace jostle::server {

namespace {

constexpr std::size_t log_message_bytes_max = 400;

// Its errors are mostly faults of single peers rather than of the server.
void write_grpc(gpr_log_func_args* entry) {
    const std::string text = printable(entry->message, log_message_bytes_max);
    if (entry->severity == GPR_LOG_SEVERITY_ERROR)
        log_warn("gRPC: {}", text);
    else
        log_debug("gRPC: {}", text);
}

// Mostly malformed messages, which the callers report themselves.
void write_protobuf(google::protobuf::LogLevel, const char*, int, const std::string& message) {
    log_debug("protobuf: {}", printable(message, log_message_bytes_max));
}

}  // namespace

void configure_libraries() {
    absl::SetMutexDeadlockDetectionMode(absl::OnDeadlockCycle::kIgnore);
    gpr_set_log_function(write_grpc);
    google::protobuf::SetLogHandler(write_protobuf);
}

}  // namespace jostle::server
