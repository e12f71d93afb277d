// SPDX-License-Identifier: MIT
//
// JSON responses of the HTTP API, and its errors. Pure functions; any thread.
#pragma once

#include <string>

#include "jostle/base/result.h"
#include "server/http/http_message.h"

namespace jostle::server {

// Not cached.
HttpResponse json_response(int status, std::string body);

// {"code": "NOT_FOUND", "message": "..."} with the corresponding HTTP status.
HttpResponse to_http(const Error& error);

}  // namespace jostle::server
