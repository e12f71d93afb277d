// SPDX-License-Identifier: MIT
//
// Serves the viewer's files from one folder only. Targets are untrusted: they are decoded once and
// checked segment by segment, and the file must be inside the folder after symbolic links are
// resolved. Next to a file there may be copies compressed by the build, FILE.br and FILE.gz; a
// client receives the smallest that it accepts. Called by HttpRoutes on the server's thread; has no
// state except the folder.
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

    // Serves a GET or HEAD: 200, 304 (the cached copy is current), 400, 404, or a page that
    // explains how to set the web root if the folder contains no viewer.
    HttpResponse serve(const HttpRequest& request) const;

private:
    HttpResponse page_without_viewer() const;

    std::filesystem::path root_;
};

// Converts "/a%20b/c" to "a b/c". Empty if the target is malformed or tries to leave its folder: an
// invalid escape, a control character, a backslash, a segment that starts with a dot, or a path
// longer than 1 kB.
std::optional<std::string> relative_path_of(std::string_view target);

// Whether Accept-Encoding, such as "gzip, br;q=0.5, *;q=0", accepts a content coding, such as "br".
bool accepts_coding(std::string_view accept_encoding, std::string_view coding);

// Based on the file extension; "application/octet-stream" if unknown.
std::string_view content_type_of(const std::filesystem::path& file);

}  // namespace jostle::server
