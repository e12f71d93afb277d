// SPDX-License-Identifier: MIT
#include "server/http/web_files.h"

#include <spdlog/fmt/fmt.h>

#include <array>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <system_error>

#include "server/http/percent_decode.h"

namespace jostle::server {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t path_length_max = 1024;
constexpr std::uintmax_t file_bytes_max = 64u << 20;  // the viewer takes about 1 MB

bool has_forbidden_character(std::string_view path) {
    for (const char c : path) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '\\') return true;
    }
    return false;
}

// Matches ".", ".." and hidden files such as ".git".
bool has_dot_segment(std::string_view path) {
    return path.starts_with('.') || path.find("/.") != std::string_view::npos;
}

bool is_inside(const fs::path& file, const fs::path& folder) {
    const fs::path relative = file.lexically_relative(folder);
    return !relative.empty() && *relative.begin() != "..";
}

HttpResponse plain(int status, std::string text) {
    return {.status = status, .headers = {}, .body = std::move(text)};
}

std::string etag_of(std::uintmax_t size, fs::file_time_type written) {
    return fmt::format("\"{:x}-{:x}\"", size, written.time_since_epoch().count());
}

// File names in assets/ contain a hash of their content, so these files never change; all other
// files must be revalidated.
std::string_view cache_control_of(std::string_view relative) {
    return relative.starts_with("assets/") ? "public, max-age=31536000, immutable" : "no-cache";
}

}  // namespace

std::optional<std::string> relative_path_of(std::string_view target) {
    const std::string_view path = path_of(target);
    if (path.empty() || path.front() != '/' || path.size() > path_length_max) return std::nullopt;
    std::optional<std::string> decoded = percent_decode(path.substr(1));
    if (!decoded || has_forbidden_character(*decoded) || has_dot_segment(*decoded) ||
        decoded->starts_with('/')) {
        return std::nullopt;
    }
    return decoded;
}

std::string_view content_type_of(const fs::path& file) {
    struct Entry {
        std::string_view extension, type;
    };
    static constexpr std::array<Entry, 15> table{{
        {".html", "text/html; charset=utf-8"},
        {".js", "text/javascript; charset=utf-8"},
        {".mjs", "text/javascript; charset=utf-8"},
        {".css", "text/css; charset=utf-8"},
        {".json", "application/json"},
        {".map", "application/json"},
        {".svg", "image/svg+xml"},
        {".png", "image/png"},
        {".jpg", "image/jpeg"},
        {".webp", "image/webp"},
        {".ico", "image/x-icon"},
        {".woff2", "font/woff2"},
        {".wasm", "application/wasm"},
        {".glb", "model/gltf-binary"},
        {".txt", "text/plain; charset=utf-8"},
    }};
    const std::string extension = file.extension().string();
    for (const Entry& entry : table) {
        if (entry.extension == extension) return entry.type;
    }
    return "application/octet-stream";
}

WebFiles::WebFiles(fs::path root) : root_(std::move(root)) {
    std::error_code error;
    const fs::path canonical = fs::canonical(root_, error);
    if (!error) root_ = canonical;
}

HttpResponse WebFiles::serve(const HttpRequest& request) const {
    if (request.method != "GET" && request.method != "HEAD") {
        HttpResponse response = plain(405, "Files are read-only; use GET.\n");
        response.headers.emplace_back("Allow", "GET, HEAD");
        return response;
    }
    std::optional<std::string> relative = relative_path_of(request.target);
    if (!relative) return plain(400, "The path is malformed or outside the viewer folder.\n");
    if (relative->empty() || relative->ends_with('/')) *relative += "index.html";

    std::error_code error;
    const fs::path file = fs::canonical(root_ / *relative, error);
    if (error || !is_inside(file, root_) || !fs::is_regular_file(file, error)) {
        if (*relative == "index.html") return page_without_viewer();
        return plain(404, "There is no such file.\n");
    }
    const std::uintmax_t size = fs::file_size(file, error);
    if (error || size > file_bytes_max) return plain(404, "There is no such file.\n");
    const fs::file_time_type written = fs::last_write_time(file, error);

    HttpResponse response;
    response.content_type = content_type_of(file);
    const std::string etag = etag_of(size, written);
    response.headers.emplace_back("ETag", etag);
    response.headers.emplace_back("Cache-Control", cache_control_of(*relative));
    if (request.if_none_match == etag) {
        response.status = 304;
        return response;
    }
    std::ifstream stream(file, std::ios::binary);
    response.body.assign(std::istreambuf_iterator<char>(stream), {});
    if (!stream) return plain(500, "Cannot read the file.\n");
    return response;
}

HttpResponse WebFiles::page_without_viewer() const {
    HttpResponse response;
    response.status = 404;
    response.content_type = "text/html; charset=utf-8";
    response.headers.emplace_back("Cache-Control", "no-store");
    response.body =
        "<!doctype html><meta charset=utf-8><title>Jostle</title>"
        "<body style=\"font:16px/1.5 system-ui;max-width:40em;margin:4em auto\">"
        "<h1>The server is running, but the viewer is missing</h1>"
        "<p>The web root of this server contains no <code>index.html</code>. "
        "Start the server from the top folder of the project, or set the web root:</p>"
        "<pre>jostle-server --web-root clients/web/dist</pre>"
        "<p>The worlds are available: <a href=\"/api/worlds\">/api/worlds</a> lists them, and "
        "<code>/play</code> accepts WebSocket clients.</p>";
    return response;
}

}  // namespace jostle::server
