// SPDX-License-Identifier: MIT
#include "server/grpc/query_methods.h"

#include <algorithm>
#include <mutex>

#include "jostle/v1/query.pb.h"

namespace jostle::server {

namespace {

constexpr std::size_t query_request_bytes_max =
    4 * 1024 * 1024;  // a hundred hulls of a thousand points

template <class Request, class Response>
CallMethod question(const QueryControl& queries, const WorldDirectory& worlds, const char* name,
                    Status (QueryControl::*ask)(const Request&, Response&, const CancellationCheck&)
                        const) {
    return world_method<Request, Response>(
        std::string("/jostle.v1.QueryService/") + name, CallWork::query, query_request_bytes_max,
        worlds,
        [&queries, ask](const CallContext& context, const Request& request, Response& response) {
            return (queries.*ask)(request, response, [&] { return !context.is_too_late(); });
        });
}

// Answers that are on their way, by the copy of the world that they tell of: who asks the same of
// the same copy gets the same bytes, however many ask at once.
class ResponseCache {
public:
    template <class Make>
    ResponseBytes find_or_make(const QueryFramePtr& frame, std::string_view request,
                               const Make& make) {
        const std::lock_guard lock(mutex_);
        std::erase_if(kept_,
                      [](const CachedResponse& kept) { return kept.response_bytes.expired(); });
        for (const CachedResponse& kept : kept_)
            if (ResponseBytes response_bytes = kept.response_bytes.lock();
                response_bytes && kept.frame.lock() == frame && kept.request == request)
                return response_bytes;
        const ResponseBytes made = make();
        kept_.push_back({frame, std::string(request), made});
        return made;
    }

private:
    struct CachedResponse {
        std::weak_ptr<const QueryFrame> frame;
        std::string request;
        std::weak_ptr<const std::string> response_bytes;
    };

    std::mutex mutex_;
    std::vector<CachedResponse> kept_;
};

CallMethod debug_method(const QueryControl& queries, const WorldDirectory& worlds) {
    const auto shared = std::make_shared<ResponseCache>();
    const auto run = [&queries, &worlds, shared](const CallContext& context, std::string_view bytes,
                                                 ResponseBytes& response_bytes) -> Status {
        v1::DebugRequest request;
        if (Status s = parse(bytes, request); !s.ok()) return s;
        if (Status s = admit(context, worlds, request.world()); !s.ok()) return s;
        const Result<QueryFramePtr> frame = queries.debug_frame(request);
        if (!frame.ok()) return frame.error();
        response_bytes = shared->find_or_make(*frame, bytes, [&] {
            v1::DebugResponse response;
            QueryControl::write_debug(request, **frame, response);
            return std::make_shared<const std::string>(response.SerializeAsString());
        });
        return {};
    };
    constexpr std::size_t debug_bytes_max = 4096;
    return {.path = "/jostle.v1.QueryService/Debug",
            .work = CallWork::query,
            .request_bytes_max = debug_bytes_max,
            .authorizes_world = true,
            .run = run};
}

}  // namespace

std::vector<CallMethod> query_methods(const QueryControl& queries, const WorldDirectory& worlds) {
    return {question(queries, worlds, "CastRays", &QueryControl::cast_rays),
            question(queries, worlds, "CastShapes", &QueryControl::cast_shapes),
            question(queries, worlds, "Overlap", &QueryControl::overlap),
            question(queries, worlds, "ClosestPoints", &QueryControl::closest_points),
            debug_method(queries, worlds)};
}

}  // namespace jostle::server
