// SPDX-License-Identifier: MIT
//
// Our Status as gRPC's with details for programs (google.rpc): which field was wrong, when to come
// again, and a reason as one word. Pure; any thread.
#pragma once

#include <grpcpp/support/status.h>

#include "jostle/base/result.h"

namespace jostle::server {

grpc::Status to_rich_status(const Status& status);

}  // namespace jostle::server
