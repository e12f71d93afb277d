// SPDX-License-Identifier: MIT
//
// The control plane: list, create, delete and join worlds. Each call blocks up to 5 s; errors are
// the server's words.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "jostle/v1/world.pb.h"

namespace jostle::client {

class WorldClient {
public:
    explicit WorldClient(const std::string& target);
    ~WorldClient();

    // Nothing on success, otherwise why not.
    std::optional<std::string> list(v1::ListWorldsResponse& response);
    std::optional<std::string> create(const v1::CreateWorldRequest& request,
                                      v1::CreateWorldResponse& response);
    std::optional<std::string> remove(const std::string& world);
    std::optional<std::string> join(const std::string& world, v1::JoinWorldResponse& response);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace jostle::client
