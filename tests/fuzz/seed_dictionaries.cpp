// SPDX-License-Identifier: MIT
#include "tests/fuzz/seed_dictionaries.h"

#include <google/protobuf/descriptor.h>

#include <cctype>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include "jostle/v1/query.pb.h"
#include "jostle/v1/scene.pb.h"
#include "jostle/v1/world.pb.h"

namespace jostle::fuzz {

namespace {

using google::protobuf::Descriptor;
using DictionaryWords = std::set<std::string>;

// Names of fields and of enumerators, of the message and of all within it.
void add_names(DictionaryWords& words, const Descriptor& message,
               std::set<const Descriptor*>& seen) {
    if (!seen.insert(&message).second) return;
    for (int k = 0; k < message.field_count(); k++) {
        const auto& field = *message.field(k);
        words.insert("\"" + field.name() + "\":");
        if (field.message_type() != nullptr) add_names(words, *field.message_type(), seen);
        if (field.enum_type() == nullptr) continue;
        for (int value = 0; value < field.enum_type()->value_count(); value++)
            words.insert("\"" + field.enum_type()->value(value)->name() + "\"");
    }
}

DictionaryWords json_words(std::initializer_list<const Descriptor*> messages) {
    DictionaryWords words{"{}", "[]",  "null",    "true",    "1e300",
                          "-1", "0.5", "\"NaN\"", "\\u0000", ","};
    std::set<const Descriptor*> seen;
    for (const Descriptor* message : messages) add_names(words, *message, seen);
    return words;
}

// What stands before a '=' or between brackets in the example.
DictionaryWords config_words() {
    std::ifstream in(std::filesystem::path(PROJECT_FOLDER) / "server/jostle-server.toml");
    const std::string text((std::istreambuf_iterator<char>(in)), {});
    DictionaryWords words{"= [",  "\"\"\"",   "inf", "nan", "1e9", "0x7f", "1979-05-27T07:32:00Z",
                          "true", "{ a = 1 }"};
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at;
        while (end < text.size() && (std::islower(text[end]) != 0 || text[end] == '_')) end++;
        if (end > at + 3) words.insert(text.substr(at, end - at));
        at = end + 1;
    }
    return words;
}

void write(const std::filesystem::path& folder, const std::string& target,
           const DictionaryWords& words) {
    std::ofstream out(folder / (target + ".dict"));
    for (const std::string& word : words) {
        out << '"';
        for (const char c : word) {
            const bool plain = c >= ' ' && c <= '~' && c != '"' && c != '\\';
            static constexpr char digits[] = "0123456789abcdef";
            if (plain)
                out << c;
            else
                out << "\\x" << digits[static_cast<unsigned char>(c) >> 4] << digits[c & 15];
        }
        out << "\"\n";
    }
}

}  // namespace

void write_dictionaries(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    write(folder, "scene_json", json_words({v1::Scene::descriptor()}));
    DictionaryWords routes =
        json_words({v1::CreateWorldRequest::descriptor(), v1::CastRaysRequest::descriptor(),
                    v1::CastShapesRequest::descriptor(), v1::OverlapRequest::descriptor(),
                    v1::ClosestPointsRequest::descriptor(), v1::DebugRequest::descriptor()});
    routes.merge(DictionaryWords{"GET\n", "POST\n", "DELETE\n", "HEAD\n", "/api/worlds/",
                                 "/api/query/", "CastRays", "CastShapes", "Overlap",
                                 "ClosestPoints", "Debug", "/play", "/readyz",
                                 "\napplication/json\n", "http://localhost"});
    write(folder, "http_routes", routes);
    write(folder, "config_text", config_words());
    write(folder, "json_web_token",
          {"\"alg\":\"ES256\"",
           "\"alg\":\"none\"",
           "\"alg\":\"HS256\"",
           "\"typ\":\"JWT\"",
           "\"kid\":\"first\"",
           "\"crit\":[]",
           "\"iss\":\"https://login.example.org\"",
           "\"aud\":[\"jostle\"]",
           "\"sub\":\"x\"",
           "\"exp\":1790000100",
           "\"nbf\":1790000000",
           "\"iat\":1790000000",
           "\"jti\":",
           "\"role\":\"admin\"",
           "\"world\":\"w1\"",
           "1e308",
           "-1",
           "{",
           "}",
           ","});
    write(folder, "key_set",
          {"\"keys\":[", "\"kty\":\"EC\"", "\"kty\":\"RSA\"", "\"crv\":\"P-256\"",
           "\"kid\":\"first\"", "\"use\":\"sig\"", "\"use\":\"enc\"", "\"alg\":\"ES256\"",
           "\"key_ops\":[\"verify\"]", "\"x\":\"", "\"y\":\"", "\"d\":\"", "{", "}", ","});
    write(folder, "bot_script",
          {"wander", "push", "throw", "builder", "drag", "watch", "weight=", "period=", "strength=",
           "speed=", "keep=", "size=", " # ", "1e-300", "inf", "nan"});
    write(folder, "http_target",
          {"%2e", "%2f", "%5c", "%00", "..", "/.", "//", "?", "#", "%c0%ae"});
    const DictionaryWords head{"GET ",
                               "POST ",
                               "HEAD ",
                               " HTTP/1.1\r\n",
                               " HTTP/1.0\r\n",
                               "Host: ",
                               "Origin: ",
                               "Content-Type: application/json\r\n",
                               "Content-Length: ",
                               "Transfer-Encoding: chunked\r\n",
                               "Expect: 100-continue\r\n",
                               "Connection: close\r\n",
                               "Connection: Upgrade\r\n",
                               "Upgrade: websocket\r\n",
                               "Sec-WebSocket-Version: 13\r\n",
                               "Sec-WebSocket-Extensions: permessage-deflate\r\n",
                               "Sec-WebSocket-Key: ",
                               "If-None-Match: ",
                               "\r\n\r\n",
                               "0\r\n",
                               "4294967296"};
    write(folder, "http_head", head);
    write(folder, "websocket", head);
}

}  // namespace jostle::fuzz
