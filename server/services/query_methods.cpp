// SPDX-License-Identifier: MIT
#include "server/services/call_method.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <mutex>

#include "jostle/v1/query.pb.h"
#include "server/limits/account.h"

namespace jostle::server {

namespace {

// A hundred hulls of a thousand points.
constexpr std::size_t query_request_bytes_max = 4 * 1024 * 1024;

// Charges the account of the caller for the call, including its decoding and encoding.
CallMethod within_budget(const QueryControl& queries, CallMethod method) {
    method.run = [&queries, run = std::move(method.run)](const CallContext& context,
                                                         std::string_view bytes,
                                                         ResponseBytes& response_bytes) -> Status {
        const QueryBudget::Spending spending(queries.budget(),
                                             account_of(context.who.subject, context.address));
        if (!spending.status().ok()) return spending.status();
        return run(context, bytes, response_bytes);
    };
    return method;
}

template <class Request, class Response>
CallMethod query_method(const QueryControl& queries, const WorldDirectory& worlds, const char* name,
                        Status (QueryControl::*query)(const Request&, Response&,
                                                      const CancellationCheck&) const) {
    return within_budget(queries,
                         world_method<Request, Response>(
                             fmt::format("/jostle.v1.QueryService/{}", name), CallWork::query,
                             query_request_bytes_max, worlds,
                             [&queries, query](const CallContext& context, const Request& request,
                                               Response& response) {
                                 return (queries.*query)(request, response,
                                                         [&] { return !context.is_too_late(); });
                             }));
}

// Responses in flight, by the copy of the world they were computed from: identical requests on the
// same copy share their bytes, regardless of how many clients query at the same time.
class ResponseCache {
public:
    template <class Make>
    ResponseBytes find_or_make(const QueryFramePtr& frame, std::string_view request,
                               const Make& make) {
        const std::lock_guard lock(mutex_);
        std::erase_if(responses_,
                      [](const CachedResponse& entry) { return entry.response_bytes.expired(); });
        for (const CachedResponse& entry : responses_)
            if (ResponseBytes response_bytes = entry.response_bytes.lock();
                response_bytes && entry.frame.lock() == frame && entry.request == request)
                return response_bytes;
        const ResponseBytes made = make();
        responses_.push_back({frame, std::string(request), made});
        return made;
    }

private:
    struct CachedResponse {
        std::weak_ptr<const QueryFrame> frame;
        std::string request;
        std::weak_ptr<const std::string> response_bytes;
    };

    std::mutex mutex_;
    std::vector<CachedResponse> responses_;
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
    return within_budget(queries, {.path = "/jostle.v1.QueryService/Debug",
                                   .work = CallWork::query,
                                   .request_bytes_max = debug_bytes_max,
                                   .authorizes_world = true,
                                   .run = run});
}

}  // namespace

std::vector<CallMethod> query_methods(const QueryControl& queries, const WorldDirectory& worlds) {
    return {query_method(queries, worlds, "CastRays", &QueryControl::cast_rays),
            query_method(queries, worlds, "CastShapes", &QueryControl::cast_shapes),
            query_method(queries, worlds, "Overlap", &QueryControl::overlap),
            query_method(queries, worlds, "ClosestPoints", &QueryControl::closest_points),
            query_method(queries, worlds, "Inspect", &QueryControl::inspect),
            debug_method(queries, worlds)};
}

}  // namespace jostle::server
