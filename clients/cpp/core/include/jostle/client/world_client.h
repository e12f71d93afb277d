// SPDX-License-Identifier: MIT
//
// The control plane: list, create, delete and join worlds. Each call blocks for up to 5 s. An error
// carries the server's message. Any thread.
#pragma once

#include <memory>
#include <string>

#include "jostle/base/result.h"
#include "jostle/client/security.h"
#include "jostle/v1/world.pb.h"

namespace jostle::client {

class WorldClient {
public:
    // Of the server's gRPC port.
    explicit WorldClient(const std::string& target, Security security = {});
    ~WorldClient();

    Result<v1::ListWorldsResponse> list();
    Result<v1::CreateWorldResponse> create(const v1::CreateWorldRequest& request);
    Status remove(const std::string& world);  // id or name
    // The ticket for ClientOptions::ticket.
    Result<v1::JoinWorldResponse> join(const std::string& world);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace jostle::client
