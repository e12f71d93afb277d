// SPDX-License-Identifier: MIT
//
// QueryService.Inspect.
#include <optional>

#include "jostle/v1/query.pb.h"
#include "server/messages/attribute_message.h"
#include "server/messages/inspection_message.h"
#include "server/services/query_control.h"
#include "server/services/query_target.h"
#include "server/world/inspection.h"

namespace jostle::server {

Status QueryControl::inspect(const v1::InspectRequest& request, v1::InspectResponse& response,
                             const CancellationCheck& still_needed) const {
    if (request.target_case() == v1::InspectRequest::TARGET_NOT_SET)
        return invalid_argument("the request has no target; set entity or joint");
    const auto world = queried_world(context_.worlds, request.world());
    if (!world.ok()) return world.error();
    std::optional<Result<BodyInspection>> body;
    std::optional<Result<JointInspection>> joint;
    Status ran;
    {
        const std::lock_guard lock(inspects_);
        if (!still_needed())
            return Error{ErrorCode::deadline_exceeded,
                         "the deadline passed while the response was computed"};
        (*world)->wake();
        ran = (*world)->between_ticks().run([&](HostedWorld& hosted) {
            if (request.has_entity())
                body = hosted.inspect_entity(request.entity());
            else
                joint = hosted.inspect_joint(request.joint());
        });
    }
    if (!ran.ok()) return ran;
    const FramePtr frame = (*world)->frame();
    response.set_tick(frame->tick);
    if (joint) {
        if (!joint->ok()) return joint->error();
        write_inspection(*response.mutable_joint(), **joint);
        return {};
    }
    if (!body->ok()) return body->error();
    write_inspection(*response.mutable_body(), **body);
    if (!frame->attributes) return {};
    const auto attributes =
        frame->attributes->find({AttributeTargetKind::entity, request.entity()});
    if (!attributes) return {};
    for (const auto& [key, attribute] : attributes->attributes)
        if (attribute.visibility == AttributeVisibility::everyone)
            write_attribute(*response.mutable_body()->add_attributes(), key, attribute);
    return {};
}

}  // namespace jostle::server
