// SPDX-License-Identifier: MIT
#include "rpc/grpc_log.h"

#include <grpc/support/log.h>

#include "base/log.h"
#include "base/text.h"

namespace jostle::server {

namespace {

constexpr std::size_t message_bytes_max = 400;

// Its errors are mostly about single peers: they are no trouble of the server's.
void write(gpr_log_func_args* said) {
    const std::string text = printable(said->message, message_bytes_max);
    if (said->severity == GPR_LOG_SEVERITY_ERROR)
        log_warn("gRPC: {}", text);
    else
        log_debug("gRPC: {}", text);
}

}  // namespace

void send_grpc_log_to_ours() {
    gpr_set_log_function(write);
}

}  // namespace jostle::server
