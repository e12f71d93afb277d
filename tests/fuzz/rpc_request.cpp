// SPDX-License-Identifier: MIT
//
// Requests of WorldService, QueryService and AdminService: the first byte names the method, the
// rest is the message. Each is answered or refused with a reason, never with "our mistake". Those
// that wait for a world's thread are left out.
#include "jostle/v1/admin.pb.h"
#include "jostle/v1/query.pb.h"
#include "jostle/v1/world.pb.h"
#include "server/services/admin_control.h"
#include "tests/fuzz/exercise_scene.h"
#include "tests/fuzz/mutate_message.h"
#include "tests/fuzz/reader.h"
#include "tests/fuzz/small_server.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

namespace {

using server::AdminControl;
using server::QueryControl;
using server::WorldControl;

struct Controls {
    SmallServer small;
    WorldControl worlds{small.context};
    QueryControl queries{small.context};
    AdminControl admin{small.context};
};

template <class Request, class Response>
using Call = Status (*)(Controls&, const Request&, Response&);

// A method: how its request is varied, and what it does with bytes.
struct Method {
    google::protobuf::Message& (*message)();
    void (*ask)(Controls&, Bytes);
    bool changes;  // it is asked of a server of its own
};

template <class Request, class Response, Call<Request, Response> call>
constexpr Method method_of(bool changes) {
    return {[]() -> google::protobuf::Message& {
                static Request request;
                return request;
            },
            [](Controls& controls, Bytes bytes) {
                Request request;
                if (!request.ParseFromArray(bytes.data(), static_cast<int>(bytes.size()))) return;
                if constexpr (std::is_same_v<Request, v1::CreateWorldRequest>)
                    if (is_too_large(request.scene())) return;
                Response response;
                const Status status = call(controls, request, response);
                if (status.ok()) return;
                expect(!status.error().message.empty(), "a refusal has a reason");
                expect(status.error().code != ErrorCode::internal,
                       "our mistake: " + status.error().message);
            },
            changes};
}

// Bans outlive an input, because all inputs share the authorizer. They are therefore lifted again,
// by the text that the list shows.
Status ban_and_lift(Controls& controls, const v1::BanRequest& request, v1::BanResponse& response) {
    const Status banned = controls.admin.ban(request, response, controls.small.anybody());
    v1::ListBansResponse listed, left;
    expect(controls.admin.list_bans({}, listed).ok(), "bans can be listed");
    expect(banned.ok() || listed.bans_size() == 0, "a refused ban is not listed");
    for (const v1::BanInfo& ban : listed.bans()) {
        v1::UnbanRequest lift;
        if (!ban.subject().empty())
            lift.set_subject(ban.subject());
        else
            lift.set_network(ban.network());
        v1::UnbanResponse lifted;
        // A short ban may have expired.
        static_cast<void>(controls.admin.unban(lift, lifted));
    }
    expect(controls.admin.list_bans({}, left).ok() && left.bans_size() == 0,
           "a listed ban can be lifted");
    return banned;
}

const Method methods[] = {
    method_of<v1::CastRaysRequest, v1::CastRaysResponse,
              [](Controls& c, const auto& in, auto& out) { return c.queries.cast_rays(in, out); }>(
        false),
    method_of<v1::CastShapesRequest, v1::CastShapesResponse,
              [](Controls& c, const auto& in, auto& out) {
                  return c.queries.cast_shapes(in, out);
              }>(false),
    method_of<v1::OverlapRequest, v1::OverlapResponse,
              [](Controls& c, const auto& in, auto& out) { return c.queries.overlap(in, out); }>(
        false),
    method_of<v1::ClosestPointsRequest, v1::ClosestPointsResponse,
              [](Controls& c, const auto& in, auto& out) {
                  return c.queries.closest_points(in, out);
              }>(false),
    method_of<v1::DebugRequest, v1::DebugResponse,
              [](Controls& c, const auto& in, auto& out) { return c.queries.debug(in, out); }>(
        false),
    method_of<v1::InspectRequest, v1::InspectResponse,
              [](Controls& c, const auto& in, auto& out) { return c.queries.inspect(in, out); }>(
        false),
    method_of<v1::CreateWorldRequest, v1::CreateWorldResponse,
              [](Controls& c, const auto& in, auto& out) {
                  return c.worlds.create(in, out, c.small.anybody(), "127.0.0.1");
              }>(true),
    method_of<v1::JoinWorldRequest, v1::JoinWorldResponse,
              [](Controls& c, const auto& in, auto& out) {
                  return c.worlds.join(in, out, c.small.anybody(), "127.0.0.1");
              }>(true),
    method_of<v1::GetWorldRequest, v1::GetWorldResponse,
              [](Controls& c, const auto& in, auto& out) { return c.worlds.get(in, out); }>(false),
    method_of<v1::DeleteWorldRequest, v1::DeleteWorldResponse,
              [](Controls& c, const auto& in, auto& out) { return c.worlds.remove(in, out); }>(
        true),
    method_of<v1::ListClientsRequest, v1::ListClientsResponse,
              [](Controls& c, const auto& in, auto& out) {
                  return c.admin.list_clients(in, out, c.small.anybody());
              }>(false),
    method_of<v1::KickRequest, v1::KickResponse,
              [](Controls& c, const auto& in, auto& out) {
                  return c.admin.kick(in, out, c.small.anybody());
              }>(false),
    method_of<v1::SetPausedRequest, v1::SetPausedResponse,
              [](Controls& c, const auto& in, auto& out) { return c.admin.set_paused(in, out); }>(
        true),
    method_of<v1::BanRequest, v1::BanResponse, ban_and_lift>(false),
    method_of<v1::UnbanRequest, v1::UnbanResponse,
              [](Controls& c, const auto& in, auto& out) { return c.admin.unban(in, out); }>(false),
    method_of<v1::ListPlayersRequest, v1::ListPlayersResponse,
              [](Controls& c, const auto& in, auto& out) {
                  return c.admin.data().list_players(in, out);
              }>(false),
    method_of<v1::GetAttributesRequest, v1::GetAttributesResponse,
              [](Controls& c, const auto& in, auto& out) {
                  return c.admin.data().get_attributes(in, out);
              }>(false),
};

const Method& method_named(std::uint8_t first) {
    return methods[first % std::size(methods)];
}

}  // namespace

void run(Bytes input) {
    Reader in(input);
    const Method& method = method_named(in.number<std::uint8_t>());
    // What changes nothing is asked of one server.
    static Controls unchanged;
    if (!method.changes) return method.ask(unchanged, in.rest());
    Controls fresh;
    method.ask(fresh, in.rest());
    for (const auto& world : fresh.small.worlds.list()) world->tick(server::Clock::now());
}

}  // namespace jostle::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t size_max, unsigned seed) {
    using namespace jostle::fuzz;
    if (size < 2 || seed % 16 == 0) return LLVMFuzzerMutate(data, size, size_max);
    return 1 +
           mutate_message(method_named(data[0]).message(), data + 1, size - 1, size_max - 1, seed);
}
