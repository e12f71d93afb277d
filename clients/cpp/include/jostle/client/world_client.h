// SPDX-License-Identifier: MIT
//
// The control plane: list, create, delete and join worlds. Each call blocks up to 5 s; errors carry
// the server's message.
#pragma once

#include <memory>
#include <string>

#include "jostle/base/result.h"
#include "jostle/v1/world.pb.h"

namespace jostle::client {

class WorldClient {
public:
    explicit WorldClient(const std::string& target);
    ~WorldClient();

    Result<v1::ListWorldsResponse> list();
    Result<v1::CreateWorldResponse> create(const v1::CreateWorldRequest& request);
    Status remove(const std::string& world);
    Result<v1::JoinWorldResponse> join(const std::string& world);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace jostle::client
