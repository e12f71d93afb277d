// SPDX-License-Identifier: MIT
//
// An RPC other than the play stream, independent of its transport (gRPC or gRPC-Web): its name, its
// limits and its handler. Messages are bytes here; unary_method() wraps a handler of two messages.
#pragma once
#include <google/protobuf/message.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "jostle/base/result.h"
#include "server/services/admin_control.h"
#include "server/services/query_control.h"
#include "server/services/world_control.h"
#include "server/session/peer.h"
#include "server/world/world_directory.h"

namespace jostle::server {

// The caller, and the deadline of the response.
struct CallContext {
    Authorizer& authorizer;
    std::string_view call;  // row of the access table
    const Identity& who;
    std::string address;
    std::chrono::system_clock::time_point deadline;
    std::function<bool()> is_cancelled;  // the client no longer waits for the response

    bool is_too_late() const {
        return deadline <= std::chrono::system_clock::now() || is_cancelled();
    }
    AccessRequest access_request(const WorldTarget& world) const { return {call, world, address}; }
};

using ResponseBytes = std::shared_ptr<const std::string>;

enum class CallWork {
    quick,     // one request, one immediate response
    query,     // like quick, on the threads that query worlds
    control,   // like quick, on the threads that create and delete worlds
    blocking,  // like quick, on the threads that wait for a world: operators' calls
    stream,    // one response per request, until the client ends the stream
    watch,     // one request, then a response after each change
};

struct CallMethod {
    std::string path;  // "/jostle.v1.WorldService/ListWorlds"
    CallWork work = CallWork::quick;
    std::size_t request_bytes_max = 64 * 1024;
    // True: the handler authorizes the call, because only it knows the world. False: the dispatcher
    // does.
    bool authorizes_world = false;
    bool is_probe = false;  // answered even if the limit of open calls is reached
    // Runs on a pool thread; the handler of a watch runs on the dispatcher's thread repeatedly.
    std::function<Status(const CallContext&, std::string_view request,
                         ResponseBytes& response_bytes)>
        run;

    // Whether the call lasts until the client ends it.
    bool stays_open() const { return work == CallWork::stream || work == CallWork::watch; }
};

inline Status parse(std::string_view bytes, google::protobuf::Message& request) {
    if (request.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return {};
    return Error{ErrorCode::invalid_argument,
                 "the request is not a valid " + request.GetDescriptor()->full_name()};
}

// Checks whether the caller may access this world.
inline Status admit(const CallContext& context, const WorldDirectory& worlds,
                    const std::string& name) {
    const std::shared_ptr<WorldHost> world = worlds.find(name);
    return context.authorizer.admit(
        context.who, context.access_request(world ? world_target(*world) : WorldTarget{}));
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

// Like unary_method() for a call about the world named by `request.world()`: the owner of that
// world affects authorization.
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

// WorldService over gRPC: decodes requests, calls WorldControl, encodes responses. Any thread.
// Both arguments must outlive the methods.
// `scene_bytes_max`: size of a request to create a world.
std::vector<CallMethod> world_methods(WorldControl& control, const WorldDirectory& worlds,
                                      std::size_t scene_bytes_max);

// QueryService over gRPC: decodes requests, calls QueryControl, encodes responses. Any thread.
// Both arguments must outlive the methods.
std::vector<CallMethod> query_methods(const QueryControl& queries, const WorldDirectory& worlds);

// AdminService over gRPC: decodes requests, calls AdminControl, encodes responses, and records
// calls that change something in the audit log. Any thread.
// Both arguments must outlive the methods.
std::vector<CallMethod> admin_methods(AdminControl& control, const WorldDirectory& worlds);

}  // namespace jostle::server
