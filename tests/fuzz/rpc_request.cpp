// SPDX-License-Identifier: MIT
//
// Requests of WorldService and QueryService: the first byte names the method, the rest is the
// message. Each is answered or refused with a reason, never with "our mistake".
#include "fuzz/mutate_message.h"
#include "fuzz/reader.h"
#include "fuzz/small_server.h"
#include "fuzz/target.h"
#include "fuzz/try_scene.h"
#include "jostle/v1/query.pb.h"
#include "jostle/v1/world.pb.h"

namespace jostle::fuzz {

namespace {

using server::QueryControl;
using server::WorldControl;

void expect_answer(const Status& status) {
    if (status.ok()) return;
    expect(!status.error().message.empty(), "a refusal has a reason");
    expect(status.error().code != ErrorCode::internal, "our mistake: " + status.error().message);
}

template <class Request, class Response, class Control, class Method>
void ask(Control& control, Method method, Bytes bytes) {
    Request request;
    if (!request.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return;
    if constexpr (std::is_same_v<Request, v1::CreateWorldRequest>)
        if (asks_for_many(request.scene())) return;
    Response response;
    expect_answer((control.*method)(request, response));
}

}  // namespace

constexpr std::uint8_t methods = 9;

void run(Bytes input) {
    Reader in(input);
    const auto method = in.number<std::uint8_t>();
    SmallServer small;
    WorldControl worlds{small.context};
    const QueryControl queries{small.context};
    switch (method % methods) {
        case 0:
            return ask<v1::CastRaysRequest, v1::CastRaysResponse>(queries, &QueryControl::cast_rays,
                                                                  in.rest());
        case 1:
            return ask<v1::CastShapesRequest, v1::CastShapesResponse>(
                queries, &QueryControl::cast_shapes, in.rest());
        case 2:
            return ask<v1::OverlapRequest, v1::OverlapResponse>(queries, &QueryControl::overlap,
                                                                in.rest());
        case 3:
            return ask<v1::ClosestPointsRequest, v1::ClosestPointsResponse>(
                queries, &QueryControl::closest_points, in.rest());
        case 4:
            return ask<v1::DebugRequest, v1::DebugResponse>(queries, &QueryControl::debug,
                                                            in.rest());
        case 5:
            ask<v1::CreateWorldRequest, v1::CreateWorldResponse>(worlds, &WorldControl::create,
                                                                 in.rest());
            for (const auto& world : small.worlds.list()) world->tick(server::Clock::now());
            return;
        case 6:
            return ask<v1::JoinWorldRequest, v1::JoinWorldResponse>(worlds, &WorldControl::join,
                                                                    in.rest());
        case 7:
            return ask<v1::GetWorldRequest, v1::GetWorldResponse>(worlds, &WorldControl::get,
                                                                  in.rest());
        case 8:
            return ask<v1::DeleteWorldRequest, v1::DeleteWorldResponse>(
                worlds, &WorldControl::remove, in.rest());
    }
}

google::protobuf::Message& message_of(std::uint8_t method) {
    static v1::CastRaysRequest rays;
    static v1::CastShapesRequest shapes;
    static v1::OverlapRequest overlap;
    static v1::ClosestPointsRequest closest;
    static v1::DebugRequest debug;
    static v1::CreateWorldRequest create;
    static v1::JoinWorldRequest join;
    static v1::GetWorldRequest get;
    static v1::DeleteWorldRequest remove;
    google::protobuf::Message* const all[methods] = {&rays,   &shapes, &overlap, &closest, &debug,
                                                     &create, &join,   &get,     &remove};
    return *all[method % methods];
}

}  // namespace jostle::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t size_max, unsigned seed) {
    using namespace jostle::fuzz;
    if (size < 2 || seed % 16 == 0) return LLVMFuzzerMutate(data, size, size_max);
    return 1 + mutate_message(message_of(data[0]), data + 1, size - 1, size_max - 1, seed);
}
