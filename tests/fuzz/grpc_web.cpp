// SPDX-License-Identifier: MIT
//
// Bodies, content types and timeouts of gRPC-Web.
#include <algorithm>

#include "server/grpc_web/grpc_web_framing.h"

#include "tests/fuzz/target.h"

namespace jostle::fuzz {

void run(Bytes input) {
    const std::string text(text_of(input));
    for (const server::GrpcWebForm form :
         {server::GrpcWebForm::binary, server::GrpcWebForm::text}) {
        const auto message = server::read_grpc_web_request(text, form);
        if (!message.ok()) {
            expect(!message.error().message.empty(), "a refusal has a reason");
            continue;
        }
        expect(message->size() < text.size(), "a message is shorter than its body");
        if (form != server::GrpcWebForm::binary) continue;
        const std::string written = server::write_grpc_web_response(*message, 0, "", "", form);
        expect(written.substr(0, text.size()) == text, "a message is written as it is read");
    }
    // Trailers are lines, whatever is in the message of a status.
    const std::string failed =
        server::write_grpc_web_response(std::nullopt, 3, text, "", server::GrpcWebForm::binary);
    expect(std::ranges::count(failed.substr(5), '\n') == (text.empty() ? 1 : 2),
           "a message stays on its line");
    if (const auto timeout = server::parse_grpc_timeout(text))
        expect(timeout->count() >= 0, "a timeout is not negative");
    if (const auto form = server::grpc_web_form(text))
        expect(server::grpc_web_form(server::content_type_of(*form)) == form,
               "a response has the form of its request");
}

}  // namespace jostle::fuzz
