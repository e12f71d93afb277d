// SPDX-License-Identifier: MIT
#include "server/session/world_admission.h"

#include "server/session/room_admission.h"
#include "server/util/text.h"

namespace jostle::server {

namespace {

Result<std::shared_ptr<WorldHost>> find_world(PlayContext& context, const std::string& name) {
    std::shared_ptr<WorldHost> world = context.worlds.find(name);
    if (world) return world;
    return Error{ErrorCode::not_found, name.empty()
                                           ? "the server has no world"
                                           : "hello.world: there is no world " + in_quotes(name)};
}

// Players need the right to send inputs in addition to the right to connect.
Status check_play_access(PlayContext& context, const Peer& peer, const Hello& hello,
                         const Identity& who, const WorldHost& world) {
    if (hello.spectator) return {};
    return context.authorizer.admit(who, {play_inputs, world_target(world), peer.address});
}

Result<AdmittedClient> admit_by_ticket(PlayContext& context, const Peer& peer, const Hello& hello,
                                       const Authorizer::Entry& entry) {
    Result<std::shared_ptr<WorldHost>> world = find_world(context, entry.world_id);
    if (!world.ok()) return world.error();
    if (Status s = check_play_access(context, peer, hello, entry.who, **world); !s.ok())
        return s.error();
    if (Status s = check_room_access(**world, entry.who, peer.address, {}, true); !s.ok())
        return s.error();
    return AdmittedClient{*std::move(world), entry.who, Tickets::digest(hello.ticket)};
}

}  // namespace

Result<Identity> identify_by_token(PlayContext& context, const Peer& peer, const Hello& hello) {
    if (hello.token.empty()) return peer.who;
    return context.authorizer.identify({.bearer = hello.token, .address = peer.address});
}

Result<Authorizer::Entry> redeem_ticket(PlayContext& context, const Peer& peer,
                                        const Hello& hello) {
    std::string named;
    if (!hello.world.empty()) {
        const Result<std::shared_ptr<WorldHost>> world = find_world(context, hello.world);
        if (!world.ok()) return world.error();
        named = (*world)->id();
    }
    return context.authorizer.redeem_ticket(hello.ticket, named, peer.address);
}

Result<AdmittedClient> admit_by_token(PlayContext& context, const Peer& peer, const Hello& hello) {
    Result<Identity> who = identify_by_token(context, peer, hello);
    if (!who.ok()) return who.error();
    Result<std::shared_ptr<WorldHost>> world = find_world(context, hello.world);
    if (!world.ok()) return world.error();
    const AccessRequest request{peer.call, world_target(**world), peer.address};
    if (Status s = context.authorizer.admit(*who, request); !s.ok()) return s.error();
    if (Status s = check_play_access(context, peer, hello, *who, **world); !s.ok())
        return s.error();
    if (Status s = check_room_access(**world, *who, peer.address, hello.join_code, false); !s.ok())
        return s.error();
    return AdmittedClient{*std::move(world), *std::move(who), {}};
}

Result<AdmittedClient> admit_to_world(PlayContext& context, const Peer& peer, const Hello& hello,
                                      const std::optional<Authorizer::Entry>& redeemed) {
    if (hello.ticket.empty()) return admit_by_token(context, peer, hello);
    if (redeemed) return admit_by_ticket(context, peer, hello, *redeemed);
    const Result<Authorizer::Entry> entry = redeem_ticket(context, peer, hello);
    if (!entry.ok()) return entry.error();
    return admit_by_ticket(context, peer, hello, *entry);
}

}  // namespace jostle::server
