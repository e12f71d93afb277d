// SPDX-License-Identifier: MIT
#include "server/grpc_web/grpc_web_routes.h"

#include <chrono>
#include <utility>

#include "server/grpc/conversions.h"
#include "server/grpc_web/grpc_web_framing.h"
#include "server/util/clock.h"
#include "server/util/text.h"

namespace jostle::server {

namespace {

constexpr std::string_view play_path = "/jostle.v1.PlayService/Play";
// Requests up to this size need no larger buffer than others.
constexpr std::size_t small_request_bytes = 64 * 1024;

HttpResponse respond(GrpcWebForm form, std::string body) {
    return {.content_type = content_type_of(form),
            .headers = {{"Cache-Control", "no-store"}},
            .body = std::move(body)};
}

grpc::Status unknown_method(std::string_view path) {
    const std::string text =
        path == play_path
            ? "gRPC-Web has no client streaming, which the play stream needs for acknowledgements "
              "and inputs; use a WebSocket at /play, which carries the same messages"
            : "there is no method " + printable(path, 200) +
                  " in gRPC-Web; WorldService and QueryService are available";
    return {grpc::StatusCode::UNIMPLEMENTED, text};
}

}  // namespace

GrpcWebRoutes::GrpcWebRoutes(std::vector<CallMethod> methods, Authorizer& authorizer,
                             RpcMetrics* metrics)
    : authorizer_(authorizer), metrics_(metrics) {
    for (CallMethod& method : methods)
        if (!method.stays_open() && method.work != CallWork::blocking)
            methods_.emplace(method.path, std::move(method));
}

const CallMethod* GrpcWebRoutes::find(const HttpRequest& request) const {
    const auto at = methods_.find(path_of(request.target));
    return at == methods_.end() ? nullptr : &at->second;
}

HttpWork GrpcWebRoutes::work_of(const HttpRequest& request) const {
    const CallMethod* const method = find(request);
    if (!method || method->work == CallWork::quick) return HttpWork::immediate;
    return method->work == CallWork::query ? HttpWork::query : HttpWork::mutation;
}

bool GrpcWebRoutes::accepts_large_body(const HttpRequest& request) const {
    const CallMethod* const method = find(request);
    return method && method->request_bytes_max > small_request_bytes;
}

HttpResponse GrpcWebRoutes::handle(const HttpRequest& request) const {
    if (request.method != "POST") {
        HttpResponse refused = plain_text(405, "gRPC-Web requires POST.\n");
        refused.headers.emplace_back("Allow", "POST, OPTIONS");
        return refused;
    }
    const std::optional<GrpcWebForm> form = grpc_web_form(request.content_type);
    if (!form)
        return plain_text(415,
                          "Send application/grpc-web or application/grpc-web-text; gRPC over "
                          "HTTP/2 has a port of its own (setting listen).\n");
    const Clock::time_point began = Clock::now();
    const CallMethod* const method = find(request);
    grpc::Status status;
    ResponseBytes response;
    if (!method) {
        status = unknown_method(path_of(request.target));
    } else {
        const Result<std::string> message = read_grpc_web_request(request.body, *form);
        status = to_rich_status(message.ok() ? run(*method, request, *message, response)
                                             : Status(message.error()));
    }
    if (metrics_)
        metrics_->handled(path_of(request.target), status.error_code(),
                          std::chrono::duration<double>(Clock::now() - began).count());
    return respond(*form,
                   write_grpc_web_response(
                       status.ok() ? std::optional<std::string_view>(*response) : std::nullopt,
                       status.error_code(), status.error_message(), status.error_details(), *form));
}

Status GrpcWebRoutes::run(const CallMethod& method, const HttpRequest& request,
                          std::string_view message, ResponseBytes& response) const {
    if (message.size() > method.request_bytes_max)
        return Error{ErrorCode::resource_exhausted,
                     "the request has " + std::to_string(message.size()) + " bytes; at most " +
                         std::to_string(method.request_bytes_max) + " are allowed"};
    auto deadline = std::chrono::system_clock::time_point::max();
    if (!request.grpc_timeout.empty()) {
        const auto timeout = parse_grpc_timeout(request.grpc_timeout);
        if (!timeout) return invalid_argument("the grpc-timeout header is malformed");
        deadline = std::chrono::system_clock::now() +
                   std::chrono::duration_cast<std::chrono::system_clock::duration>(*timeout);
    }
    const Result<std::string_view> bearer = parse_bearer(request.authorization);
    if (!bearer.ok()) return bearer.error();
    const Result<Identity> who = authorizer_.identify(
        {.bearer = *bearer, .certificate = request.certificate, .address = request.address});
    if (!who.ok()) return who.error();
    const CallContext context{.authorizer = authorizer_,
                              .call = std::string_view(method.path).substr(1),
                              .who = *who,
                              .address = request.address,
                              .deadline = deadline,
                              .is_cancelled = [] { return false; }};
    if (!method.authorizes_world)
        if (Status s = authorizer_.admit(*who, context.access_request({})); !s.ok()) return s;
    if (context.is_too_late())
        return Error{ErrorCode::deadline_exceeded, "the deadline has passed"};
    return method.run(context, message, response);
}

}  // namespace jostle::server
