// SPDX-License-Identifier: MIT
#include "server/session/world_admission.h"

#include "server/util/text.h"

namespace jostle::server {

namespace {

Result<std::shared_ptr<WorldHost>> find_world(PlayContext& context, const std::string& name) {
    std::shared_ptr<WorldHost> world = context.worlds.find(name);
    if (world) return world;
    return Error{ErrorCode::not_found, name.empty()
                                           ? "the server has no world"
                                           : "hello.world: there is no world " + quoted(name)};
}

// Players need the right to send inputs in addition to the right to connect.
Status check_play_access(PlayContext& context, const Peer& peer, const Hello& hello,
                         const Identity& who, const WorldHost& world) {
    if (hello.spectator) return {};
    return context.authorizer.admit(who, {play_inputs, world_target(world), peer.address});
}

Result<AdmittedClient> admit_by_ticket(PlayContext& context, const Peer& peer, const Hello& hello) {
    std::string named;
    if (!hello.world.empty()) {
        const Result<std::shared_ptr<WorldHost>> world = find_world(context, hello.world);
        if (!world.ok()) return world.error();
        named = (*world)->id();
    }
    const Result<Authorizer::Entry> entry =
        context.authorizer.redeem_ticket(hello.ticket, named, peer.address);
    if (!entry.ok()) return entry.error();
    Result<std::shared_ptr<WorldHost>> world = find_world(context, entry->world_id);
    if (!world.ok()) return world.error();
    if (Status s = check_play_access(context, peer, hello, entry->who, **world); !s.ok())
        return s.error();
    return AdmittedClient{*std::move(world), entry->who.subject, true};
}

}  // namespace

Result<AdmittedClient> admit_by_token(PlayContext& context, const Peer& peer, const Hello& hello) {
    const Result<Identity> who =
        hello.token.empty()
            ? peer.who
            : context.authorizer.identify({.bearer = hello.token, .address = peer.address});
    if (!who.ok()) return who.error();
    Result<std::shared_ptr<WorldHost>> world = find_world(context, hello.world);
    if (!world.ok()) return world.error();
    const AccessRequest request{peer.call, world_target(**world), peer.address};
    if (Status s = context.authorizer.admit(*who, request); !s.ok()) return s.error();
    if (Status s = check_play_access(context, peer, hello, *who, **world); !s.ok())
        return s.error();
    return AdmittedClient{*std::move(world), who->subject, false};
}

Result<AdmittedClient> admit_to_world(PlayContext& context, const Peer& peer, const Hello& hello) {
    return hello.ticket.empty() ? admit_by_token(context, peer, hello)
                                : admit_by_ticket(context, peer, hello);
}

}  // namespace jostle::server
