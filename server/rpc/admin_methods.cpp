// SPDX-License-Identifier: MIT
#include "rpc/admin_methods.h"

#include <string_view>

#include "jostle/v1/admin.pb.h"

namespace jostle::server {

namespace {

constexpr std::size_t request_bytes_max = 4096;

// As gRPC names peers: "ipv4:127.0.0.1:4711", "ipv6:[::1]:4711", or with the brackets escaped.
bool is_of_this_machine(std::string_view peer) {
    for (const std::string_view here : {"ipv4:127.", "ipv6:[::1]", "ipv6:%5B::1%5D",
                                        "ipv6:[::ffff:127.", "ipv6:%5B::ffff:127.", "unix:"})
        if (peer.starts_with(here)) return true;
    return false;
}

template <class Request, class Response>
CallMethod method(AdminControl& control, const char* name, CallWork work,
                  Status (AdminControl::*handle)(const Request&, Response&)) {
    return unary_method<Request, Response>(
        std::string("/jostle.v1.AdminService/") + name, work, request_bytes_max,
        [&control, handle](const CallContext& context, const Request& request,
                           Response& response) -> Status {
            if (!is_of_this_machine(context.peer))
                return Error{ErrorCode::permission_denied,
                             "operators' calls are taken from this machine alone; log in there"};
            return (control.*handle)(request, response);
        });
}

}  // namespace

std::vector<CallMethod> admin_methods(AdminControl& control) {
    using enum CallWork;
    return {method(control, "ListClients", quick, &AdminControl::list_clients),
            method(control, "Kick", quick, &AdminControl::kick),
            method(control, "SetPaused", quick, &AdminControl::set_paused),
            method(control, "Drain", quick, &AdminControl::drain),
            method(control, "StepWorld", waits, &AdminControl::step_world),
            method(control, "ExportWorld", waits, &AdminControl::export_world),
            method(control, "Profile", waits, &AdminControl::profile)};
}

}  // namespace jostle::server
