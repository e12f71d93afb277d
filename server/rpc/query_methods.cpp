// SPDX-License-Identifier: MIT
#include "rpc/query_methods.h"

#include "jostle/v1/query.pb.h"

namespace jostle::server {

namespace {

constexpr std::size_t question_bytes_max = 4 * 1024 * 1024;  // a hundred hulls of a thousand points

template <class Request, class Response>
CallMethod question(const QueryControl& queries, const WorldDirectory& worlds, const char* name,
                    Status (QueryControl::*ask)(const Request&, Response&, const StillWanted&)
                        const) {
    return world_method<Request, Response>(
        std::string("/jostle.v1.QueryService/") + name, CallWork::query, question_bytes_max, worlds,
        [&queries, ask](const CallContext& context, const Request& request, Response& response) {
            return (queries.*ask)(request, response, [&] { return !context.is_too_late(); });
        });
}

}  // namespace

std::vector<CallMethod> query_methods(const QueryControl& queries, const WorldDirectory& worlds) {
    return {question(queries, worlds, "CastRays", &QueryControl::cast_rays),
            question(queries, worlds, "CastShapes", &QueryControl::cast_shapes),
            question(queries, worlds, "Overlap", &QueryControl::overlap),
            question(queries, worlds, "ClosestPoints", &QueryControl::closest_points),
            question(queries, worlds, "Debug", &QueryControl::debug)};
}

}  // namespace jostle::server
