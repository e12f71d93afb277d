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

namespace jostle::server {

// Who calls, and until when the answer is of use.
struct CallContext {
    std::string peer;  // as gRPC names it
    std::chrono::system_clock::time_point deadline;
    std::function<bool()> gave_up;  // nobody waits for the answer any more

    bool is_too_late() const { return deadline <= std::chrono::system_clock::now() || gave_up(); }
};

using AnswerBytes = std::shared_ptr<const std::string>;

enum class CallWork {
    quick,    // one request, one answer at once
    query,    // likewise, on the threads of what asks worlds
    control,  // likewise, on the threads of what changes worlds
    waits,    // likewise, on the threads of what waits for a world: operators' calls
    stream,   // an answer for each request, until the client ends it
    watch,    // one request, then an answer whenever there is another one
};

struct CallMethod {
    std::string path;  // "/jostle.v1.WorldService/ListWorlds"
    CallWork work = CallWork::quick;
    std::size_t request_bytes_max = 64 * 1024;
    // On a thread of a pool; a watch's on that of the front, again and again.
    std::function<Status(const CallContext&, std::string_view request, AnswerBytes& answer)> run;
};

// `handle` is called as Status(const CallContext&, const Request&, Response&).
template <class Request, class Response, class Handle>
CallMethod unary_method(std::string path, CallWork work, std::size_t request_bytes_max,
                        Handle handle) {
    auto run = [handle = std::move(handle)](const CallContext& context, std::string_view bytes,
                                            AnswerBytes& answer) -> Status {
        Request request;
        if (!request.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())))
            return Error{ErrorCode::invalid_argument,
                         "the request is no " + request.GetDescriptor()->full_name()};
        Response response;
        if (Status s = handle(context, request, response); !s.ok()) return s;
        answer = std::make_shared<const std::string>(response.SerializeAsString());
        return {};
    };
    return {std::move(path), work, request_bytes_max, std::move(run)};
}

}  // namespace jostle::server
