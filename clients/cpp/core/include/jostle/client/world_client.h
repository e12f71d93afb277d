// SPDX-License-Identifier: MIT
//
// Client of the control plane: lists, creates, deletes and joins worlds. Each call blocks for up to
// 5 s. Errors contain the server's message. Any thread.
#pragma once

#include <memory>
#include <string>

#include "jostle/base/result.h"
#include "jostle/client/security.h"
#include "jostle/v1/world.pb.h"

namespace jostle::client {

/// Blocking client of WorldService.
class WorldClient {
public:
    /// `target`: host:port of the server's gRPC listener.
    explicit WorldClient(const std::string& target, Security security = {});
    ~WorldClient();

    /// Lists the worlds and the catalogue scenes. `request`: a filter of worlds and rooms.
    Result<v1::ListWorldsResponse> list(const v1::ListWorldsRequest& request = {});
    /// Creates a world.
    Result<v1::CreateWorldResponse> create(const v1::CreateWorldRequest& request);
    Status remove(const std::string& world);  ///< deletes a world; id or name
    /// Returns a ticket for ClientOptions::ticket. `join_code`: of a private room.
    Result<v1::JoinWorldResponse> join(const std::string& world, const std::string& join_code = {});
    /// Joins a room that matches, or else creates one and joins it.
    Result<v1::JoinOrCreateWorldResponse> join_or_create(
        const v1::JoinOrCreateWorldRequest& request);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace jostle::client
