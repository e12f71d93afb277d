// SPDX-License-Identifier: MIT
//
// Targets of HTTP requests, as file names and as questions: nothing leads out of the viewer's
// folder.
#include "server/http/percent_decode.h"
#include "server/http/web_files.h"
#include "tests/fuzz/target.h"

namespace jostle::fuzz {

void run(Bytes input) {
    const std::string_view target = text_of(input);
    if (const auto world = server::query_field(target, "world"))
        expect(world->size() <= target.size(), "what is decoded is no longer than it was");
    const auto path = server::relative_path_of(target);
    if (!path) return;
    expect(!path->starts_with('/'), "a path is relative");
    expect(path->find("..") == std::string::npos || path->find("/..") == std::string::npos,
           "a path does not climb");
    expect(!path->starts_with("."), "hidden files stay hidden");
    for (const char c : *path)
        expect(static_cast<unsigned char>(c) >= 0x20 && c != '\\', "a path is plain");
    expect(!server::content_type_of(*path).empty(), "a file has a type");
}

}  // namespace jostle::fuzz
