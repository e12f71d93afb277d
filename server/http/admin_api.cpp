// SPDX-License-Identifier: MIT
#include "server/http/admin_api.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>
#include <google/protobuf/util/json_util.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>

#include "jostle/base/check.h"
#include "jostle/v1/admin.pb.h"
#include "server/http/http_error.h"

namespace jostle::server {
namespace {

namespace pb = google::protobuf;

constexpr std::array<std::string_view, 14> available = {
    "GetServerStatus", "ListClients", "Kick",      "Ban",        "Unban",
    "ListBans",        "SetPaused",   "StepWorld", "GetRoom",    "ModerateRoom",
    "RemoveBodies",    "UndoClient",  "Drain",     "ListReports"};

std::unique_ptr<pb::Message> make(const pb::Descriptor& type) {
    return std::unique_ptr<pb::Message>(
        pb::MessageFactory::generated_factory()->GetPrototype(&type)->New());
}

const pb::MethodDescriptor* find_method(std::string_view name) {
    if (std::ranges::find(available, name) == available.end()) return nullptr;
    // The file's descriptor is registered by its first message.
    const pb::FileDescriptor& file = *v1::KickRequest::descriptor()->file();
    const pb::ServiceDescriptor* const service = file.FindServiceByName("AdminService");
    ASSERT(service);
    return service->FindMethodByName(std::string(name));
}

}  // namespace

HttpResponse AdminApi::call(const HttpRequest& request, std::string_view name,
                            const Identity& who) const {
    const pb::MethodDescriptor* const type = find_method(name);
    const std::string path = "/jostle.v1.AdminService/" + std::string(name);
    const auto method = std::ranges::find(methods_, path, &CallMethod::path);
    if (!type || method == methods_.end())
        return to_http(
            Error{ErrorCode::not_found, "there is no such method of AdminService over HTTP"});
    const AccessRow* const row = find_call(path);
    ASSERT(row);
    if (request.body.size() > method->request_bytes_max)
        return to_http(invalid_argument(
            "the body has " + std::to_string(request.body.size()) + " bytes; at most " +
            std::to_string(method->request_bytes_max) + " are allowed"));
    const std::unique_ptr<pb::Message> message = make(*type->input_type());
    const auto read = pb::util::JsonStringToMessage(request.body, message.get());
    if (!read.ok())
        return to_http(invalid_argument("the body is not a " + type->input_type()->full_name() +
                                        " as JSON: " + std::string(read.message())));
    if (!method->authorizes_world)
        if (Status s = authorizer_.admit(who, {row->call, {}, request.address}); !s.ok())
            return to_http(s.error());
    const CallContext context{.authorizer = authorizer_,
                              .call = row->call,
                              .who = who,
                              .address = request.address,
                              .deadline = std::chrono::system_clock::time_point::max(),
                              .is_cancelled = [] { return false; }};
    ResponseBytes bytes;
    if (Status s = method->run(context, message->SerializeAsString(), bytes); !s.ok())
        return to_http(s.error());
    const std::unique_ptr<pb::Message> response = make(*type->output_type());
    pb::util::JsonPrintOptions options;
    options.always_print_primitive_fields = true;
    std::string text;
    if (!response->ParseFromString(*bytes) ||
        !pb::util::MessageToJsonString(*response, &text, options).ok())
        return to_http(Error{ErrorCode::internal, "cannot encode the response as JSON"});
    return json_response(200, std::move(text));
}

}  // namespace jostle::server
