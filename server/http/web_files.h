// SPDX-License-Identifier: MIT
//
// The viewer's files, from one folder and nowhere else. Targets come from strangers: they are
// decoded once, checked segment by segment, and what they name must lie inside the folder after
// links are followed. Called by http_routes on the gateway's thread; holds no state but the folder.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "server/http/http_message.h"

namespace jostle::server {

class WebFiles {
public:
    explicit WebFiles(std::filesystem::path root);

    // GET or HEAD of a file: 200, 304 (the browser's copy is current), 400, 404, or a page that
    // says how to build the viewer when the folder has none.
    HttpResponse serve(const HttpRequest& request) const;

private:
    HttpResponse page_without_viewer() const;

    std::filesystem::path root_;
};

// "/a%20b/c" to "a b/c"; nothing when the target is malformed or tries to leave its folder: a bad
// escape, a control character, a backslash, a segment that begins with a dot, a path longer than 1
// kB.
std::optional<std::string> relative_path_of(std::string_view target);

// By the file's extension; "application/octet-stream" when unknown.
std::string_view content_type_of(const std::filesystem::path& file);

}  // namespace jostle::server
