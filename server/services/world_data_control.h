// SPDX-License-Identifier: MIT
//
// Calls of administrators about the players, attributes, user messages and bodies of a world.
// Changes are applied between two ticks as commands of the server, so they are journalled. Any
// thread.
#pragma once

#include <atomic>

#include "jostle/base/result.h"
#include "server/auth/identity.h"
#include "server/session/play_context.h"

namespace jostle::v1 {
class ApplyInputRequest;
class ApplyInputResponse;
class GetAttributesRequest;
class GetAttributesResponse;
class ListPlayersRequest;
class ListPlayersResponse;
class ListReportsRequest;
class ListReportsResponse;
class ReportInfo;
class SendMessageRequest;
class SendMessageResponse;
class SetAttributesRequest;
class SetAttributesResponse;
class SetPlayerRoleRequest;
class SetPlayerRoleResponse;
}  // namespace jostle::v1

namespace google::protobuf {
template <typename Element>
class RepeatedPtrField;
}

namespace jostle::server {

class WorldDataControl {
public:
    explicit WorldDataControl(PlayContext& context) : context_(context) {}

    Status list_players(const v1::ListPlayersRequest& request, v1::ListPlayersResponse& response);
    Status set_player_role(const v1::SetPlayerRoleRequest& request,
                           v1::SetPlayerRoleResponse& response);
    Status get_attributes(const v1::GetAttributesRequest& request,
                          v1::GetAttributesResponse& response);
    Status set_attributes(const v1::SetAttributesRequest& request,
                          v1::SetAttributesResponse& response);
    Status send_message(const v1::SendMessageRequest& request, v1::SendMessageResponse& response);
    Status apply_input(const v1::ApplyInputRequest& request, v1::ApplyInputResponse& response);
    Status list_reports(const v1::ListReportsRequest& request, v1::ListReportsResponse& response,
                        const Identity& who);
    // The reports of all worlds that the caller's token opens.
    void write_reports(google::protobuf::RepeatedPtrField<v1::ReportInfo>& to,
                       const Identity& who) const;

private:
    // Applies an action of the server between two ticks. `number`: of user messages after it.
    Status apply(WorldHost& world, const Action& action, std::uint32_t* number = nullptr) const;

    PlayContext& context_;
};

}  // namespace jostle::server
