// SPDX-License-Identifier: MIT
//
// Converts a Status to a gRPC status with google.rpc details for programs: the invalid field, the
// time to retry, and a one-word reason. Pure; any thread.
#pragma once

#include <grpcpp/support/status.h>

#include "jostle/base/result.h"

namespace jostle::server {

grpc::Status to_rich_status(const Status& status);

}  // namespace jostle::server
