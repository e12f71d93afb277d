// SPDX-License-Identifier: MIT
//
// What all calls of the unary services have in common.
#pragma once

#include <grpcpp/server_context.h>

#include <chrono>

#include "status/grpc_status.h"

namespace jostle::server {

// Nobody waits for the answer any more.
inline bool is_too_late(const grpc::ServerContext& context) {
    return context.IsCancelled() || context.deadline() <= std::chrono::system_clock::now();
}

// Does the work unless it is too late for it, and answers.
template <class Work>
grpc::Status answer(const grpc::ServerContext& context, const Work& work) {
    if (is_too_late(context)) {
        return {grpc::StatusCode::DEADLINE_EXCEEDED, "the deadline has passed"};
    }
    return to_grpc(work());
}

}  // namespace jostle::server
