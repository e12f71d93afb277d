// SPDX-License-Identifier: MIT
#include "server/http/web_files.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
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

std::string etag_of(std::uintmax_t size, fs::file_time_type written, std::string_view coding) {
    return fmt::format("\"{:x}-{:x}{}{}\"", size, written.time_since_epoch().count(),
                       coding.empty() ? "" : "-", coding);
}

// File names in assets/ contain a hash of their content, so these files never change; all other
// files must be revalidated.
std::string_view cache_control_of(std::string_view relative) {
    return relative.starts_with("assets/") ? "public, max-age=31536000, immutable" : "no-cache";
}

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

bool equal_ignoring_case(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
    return std::ranges::equal(a, b, {}, lower, lower);
}

// A weight of zero: "q=0" to "q=0.000".
bool is_excluded(std::string_view parameters) {
    const std::size_t equals = parameters.find('=');
    if (equals == std::string_view::npos) return false;
    if (!equal_ignoring_case(trimmed(parameters.substr(0, equals)), "q")) return false;
    const std::string_view weight = trimmed(parameters.substr(equals + 1));
    return !weight.empty() && weight.find_first_not_of("0.") == std::string_view::npos;
}

struct Coding {
    std::string_view name, suffix;
};
constexpr std::array<Coding, 2> codings{{{"br", ".br"}, {"gzip", ".gz"}}};  // smallest first

}  // namespace

bool accepts_coding(std::string_view accept_encoding, std::string_view coding) {
    bool any = false;
    while (!accept_encoding.empty()) {
        const std::size_t comma = std::min(accept_encoding.find(','), accept_encoding.size());
        const std::string_view entry = accept_encoding.substr(0, comma);
        accept_encoding.remove_prefix(std::min(comma + 1, accept_encoding.size()));
        const std::size_t end = std::min(entry.find(';'), entry.size());
        const std::string_view name = trimmed(entry.substr(0, end));
        const bool excluded = is_excluded(end < entry.size() ? entry.substr(end + 1) : "");
        if (equal_ignoring_case(name, coding)) return !excluded;
        if (name == "*") any = !excluded;
    }
    return any;
}

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
    fs::path file = fs::canonical(root_ / *relative, error);
    if (error || !is_inside(file, root_) || !fs::is_regular_file(file, error)) {
        if (*relative == "index.html") return page_without_viewer();
        return plain(404, "There is no such file.\n");
    }
    HttpResponse response;
    response.content_type = content_type_of(file);
    const std::string uncompressed = file.string();
    std::string_view coding;
    bool has_copies = false;
    for (const Coding& known : codings) {
        const fs::path copy = uncompressed + std::string(known.suffix);
        std::error_code absent;
        if (!fs::is_regular_file(fs::symlink_status(copy, absent))) continue;
        has_copies = true;
        if (!coding.empty() || !accepts_coding(request.accept_encoding, known.name)) continue;
        coding = known.name;
        file = copy;
    }
    const std::uintmax_t size = fs::file_size(file, error);
    if (error || size > file_bytes_max) return plain(404, "There is no such file.\n");
    const fs::file_time_type written = fs::last_write_time(file, error);

    // Caches store one copy for each encoding, also of a 304.
    if (has_copies) response.headers.emplace_back("Vary", "Accept-Encoding");
    if (!coding.empty()) response.headers.emplace_back("Content-Encoding", coding);
    const std::string etag = etag_of(size, written, coding);
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
