// SPDX-License-Identifier: MIT
//
// Methods of AdminService as JSON over HTTP, for the monitor page: POST /api/admin/{method}.
// Methods that return large data or wait for long are available over gRPC only. Any thread.
#pragma once

#include <string_view>
#include <vector>

#include "server/auth/authorizer.h"
#include "server/http/http_message.h"
#include "server/services/call_method.h"

namespace jostle::server {

class AdminApi {
public:
    // `methods`: of AdminService.
    AdminApi(Authorizer& authorizer, std::vector<CallMethod> methods)
        : authorizer_(authorizer), methods_(std::move(methods)) {}

    // Authorizes and runs a call of `who`.
    HttpResponse call(const HttpRequest& request, std::string_view method,
                      const Identity& who) const;

private:
    Authorizer& authorizer_;
    const std::vector<CallMethod> methods_;
};

}  // namespace jostle::server
