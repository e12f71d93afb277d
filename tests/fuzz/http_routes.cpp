// SPDX-License-Identifier: MIT
//
// Requests as the gateway has read them, line by line: method, target, host, origin, content type,
// If-None-Match, authorization, and the body. Each is answered, never with "our mistake".
#include "server/http/http_routes.h"

#include <google/protobuf/util/json_util.h>

#include <nlohmann/json.hpp>

#include "jostle/v1/world.pb.h"
#include "tests/fuzz/exercise_scene.h"
#include "tests/fuzz/small_server.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

namespace {

std::string take_line(std::string_view& text) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string line(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

bool is_too_large(const server::HttpRequest& request) {
    if (request.body.find("repeat") == std::string::npos) return false;
    v1::CreateWorldRequest message;
    static_cast<void>(google::protobuf::util::JsonStringToMessage(request.body, &message));
    return fuzz::is_too_large(message.scene());
}

struct Routes {
    void handle(const server::HttpRequest& request) {
        const server::HttpResponse response = routes.handle(request);
        expect(response.status >= 200 && response.status < 600 && response.status != 500,
               "an answer has a status, and is no mistake of ours: " + response.body);
        expect(!response.content_type.empty(), "an answer has a type");
        if (response.content_type == "application/json")
            expect(nlohmann::json::accept(response.body), "JSON is JSON");
        // What was made runs.
        if (small.worlds.list().size() > 1) small.worlds.list().back()->tick(server::Clock::now());
    }

    SmallServer small;
    server::WorldControl control{small.context};
    const server::QueryControl queries{small.context};
    const server::HttpRoutes routes{
        control,
        queries,
        {.web_root = WEB_ROOT,
         .not_ready_reason = [] { return std::optional<std::string>(); },
         .failure_reason = [] { return std::nullopt; }}};
};

}  // namespace

void run(Bytes input) {
    std::string_view text = text_of(input);
    server::HttpRequest request;
    for (std::string* part :
         {&request.method, &request.target, &request.host, &request.origin, &request.content_type,
          &request.if_none_match, &request.authorization})
        *part = take_line(text);
    request.body = text;
    if (is_too_large(request)) return;

    // What changes nothing is asked of one server.
    static Routes unchanged;
    if (request.method != "POST" && request.method != "DELETE") return unchanged.handle(request);
    if (request.target.starts_with("/api/query/")) return unchanged.handle(request);
    Routes().handle(request);
}

}  // namespace jostle::fuzz
