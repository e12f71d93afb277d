// SPDX-License-Identifier: MIT
//
// An RPC that is not a play stream, as the call front knows it: its name, its bounds and who
// answers it. Messages are bytes here; unary_method() makes one of a function of two messages.
#pragma once

#include <google/protobuf/message.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "jostle/base/result.h"
#include "server/session/peer.h"
#include "server/world/world_directory.h"

namespace jostle::server {

// Who calls, and until when the answer is of use.
struct CallContext {
    Authorizer& authorizer;
    std::string_view call;  // the row of the access table
    const Identity& who;
    std::string address;
    std::chrono::system_clock::time_point deadline;
    std::function<bool()> is_cancelled;  // nobody waits for the answer any more

    bool is_too_late() const {
        return deadline <= std::chrono::system_clock::now() || is_cancelled();
    }
    AccessRequest ask(const WorldTarget& world) const { return {call, world, address}; }
};

using ResponseBytes = std::shared_ptr<const std::string>;

enum class CallWork {
    quick,     // one request, one answer at once
    query,     // likewise, on the threads of what asks worlds
    control,   // likewise, on the threads of what changes worlds
    blocking,  // likewise, on the threads of what waits for a world: operators' calls
    stream,    // an answer for each request, until the client ends it
    watch,     // one request, then an answer whenever there is another one
};

struct CallMethod {
    std::string path;  // "/jostle.v1.WorldService/ListWorlds"
    CallWork work = CallWork::quick;
    std::size_t request_bytes_max = 64 * 1024;
    // Calls about a world ask the gate when they know which; for the others the front has asked.
    bool authorizes_world = false;
    bool is_probe = false;  // is answered however many calls of others are open
    // On a thread of a pool; a watch's on that of the front, again and again.
    std::function<Status(const CallContext&, std::string_view request,
                         ResponseBytes& response_bytes)>
        run;

    // Until its client ends it.
    bool stays_open() const { return work == CallWork::stream || work == CallWork::watch; }
};

inline Status parse(std::string_view bytes, google::protobuf::Message& request) {
    if (request.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return {};
    return Error{ErrorCode::invalid_argument,
                 "the request is no " + request.GetDescriptor()->full_name()};
}

// Whether who calls may do so with this world.
inline Status admit(const CallContext& context, const WorldDirectory& worlds,
                    const std::string& name) {
    const std::shared_ptr<WorldHost> world = worlds.find(name);
    return context.authorizer.admit(context.who,
                                    context.ask(world ? world_target(*world) : WorldTarget{}));
}

// `handle` is called as Status(const CallContext&, const Request&, Response&).
template <class Request, class Response, class Handle>
CallMethod unary_method(std::string path, CallWork work, std::size_t request_bytes_max,
                        Handle handle) {
    auto run = [handle = std::move(handle)](const CallContext& context, std::string_view bytes,
                                            ResponseBytes& response_bytes) -> Status {
        Request request;
        if (Status s = parse(bytes, request); !s.ok()) return s;
        Response response;
        if (Status s = handle(context, request, response); !s.ok()) return s;
        response_bytes = std::make_shared<const std::string>(response.SerializeAsString());
        return {};
    };
    return {.path = std::move(path),
            .work = work,
            .request_bytes_max = request_bytes_max,
            .run = std::move(run)};
}

// The same of a call about the world that `request.world()` names: it is let in by whose that is.
template <class Request, class Response, class Handle>
CallMethod world_method(std::string path, CallWork work, std::size_t request_bytes_max,
                        const WorldDirectory& worlds, Handle handle) {
    CallMethod method = unary_method<Request, Response>(
        std::move(path), work, request_bytes_max,
        [&worlds, handle = std::move(handle)](const CallContext& context, const Request& request,
                                              Response& response) -> Status {
            if (Status s = admit(context, worlds, request.world()); !s.ok()) return s;
            return handle(context, request, response);
        });
    method.authorizes_world = true;
    return method;
}

}  // namespace jostle::server
