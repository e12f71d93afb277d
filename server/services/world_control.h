// SPDX-License-Identifier: MIT
//
// WorldService without a transport: what rpc/world_service and the gateway's /api/worlds both
// answer with. Any thread; create() takes as long as building the world takes.
#pragma once

#include <string>

#include "jostle/base/result.h"
#include "server/session/play_context.h"

namespace jostle::v1 {
class CreateWorldRequest;
class CreateWorldResponse;
class DeleteWorldRequest;
class DeleteWorldResponse;
class GetWorldRequest;
class GetWorldResponse;
class JoinWorldRequest;
class JoinWorldResponse;
class ListWorldsRequest;
class ListWorldsResponse;
}  // namespace jostle::v1

namespace jostle::server {

// Where clients are sent; known only after the ports are bound.
struct PlayAddresses {
    std::string grpc;       // host:port
    std::string websocket;  // ws://host:port/play
};

class WorldControl {
public:
    explicit WorldControl(PlayContext& context) : context_(context) {}

    // Before the first call of join().
    void set_addresses(PlayAddresses addresses) { addresses_ = std::move(addresses); }

    Status list(const v1::ListWorldsRequest& request, v1::ListWorldsResponse& response) const;
    Status get(const v1::GetWorldRequest& request, v1::GetWorldResponse& response) const;
    // It belongs to whoever asks, from that address.
    Status create(const v1::CreateWorldRequest& request, v1::CreateWorldResponse& response,
                  const Identity& who, const std::string& address);
    Status remove(const v1::DeleteWorldRequest& request, v1::DeleteWorldResponse& response);
    // The ticket is that of whoever asks, from that address.
    Status join(const v1::JoinWorldRequest& request, v1::JoinWorldResponse& response,
                const Identity& who, const std::string& address);
    // What a request is about, for the gate; null: there is no such world.
    std::shared_ptr<WorldHost> find(const std::string& world) const {
        return context_.worlds.find(world);
    }
    Authorizer& authorizer() const { return context_.authorizer; }

private:
    Result<std::shared_ptr<WorldHost>> create_from(const v1::CreateWorldRequest& request,
                                                   const Identity& who, const std::string& address);

    PlayContext& context_;
    PlayAddresses addresses_;
};

}  // namespace jostle::server
