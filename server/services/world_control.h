// SPDX-License-Identifier: MIT
//
// WorldService without a transport, used by gRPC (grpc/world_methods.cpp) and by /api/worlds over
// HTTP. Any thread; create() blocks until the world is built.
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
class JoinOrCreateWorldRequest;
class JoinOrCreateWorldResponse;
class JoinWorldRequest;
class JoinWorldResponse;
class ListWorldsRequest;
class ListWorldsResponse;
}  // namespace jostle::v1

namespace jostle::server {

// The addresses sent to clients; known only after the ports are bound.
struct PlayAddresses {
    std::string grpc;       // host:port
    std::string websocket;  // ws://host:port/play
};

class WorldControl {
public:
    explicit WorldControl(PlayContext& context) : context_(context) {}

    // Call before the first join().
    void set_addresses(PlayAddresses addresses) { addresses_ = std::move(addresses); }

    // Lists the worlds that the token of `who` opens.
    Status list(const v1::ListWorldsRequest& request, v1::ListWorldsResponse& response,
                const Identity& who) const;
    Status get(const v1::GetWorldRequest& request, v1::GetWorldResponse& response) const;
    // The caller becomes the owner of the world.
    Status create(const v1::CreateWorldRequest& request, v1::CreateWorldResponse& response,
                  const Identity& who, const std::string& address);
    // Clears the pause of a world.
    Status resume(const std::string& world, v1::GetWorldResponse& response);
    Status remove(const v1::DeleteWorldRequest& request, v1::DeleteWorldResponse& response);
    // The ticket is issued to the caller.
    Status join(const v1::JoinWorldRequest& request, v1::JoinWorldResponse& response,
                const Identity& who, const std::string& address);
    // Joins a room that matches, or creates one. The transport has admitted the call to join;
    // creating a world is admitted and recorded here.
    Status join_or_create(const v1::JoinOrCreateWorldRequest& request,
                          v1::JoinOrCreateWorldResponse& response, const Identity& who,
                          const std::string& address);
    // The world of a request, for authorization; null: no such world.
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
