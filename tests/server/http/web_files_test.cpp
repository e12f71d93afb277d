// SPDX-License-Identifier: MIT
#include "server/http/web_files.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temp_folder.h"

namespace jostle::server {
namespace {

namespace fs = std::filesystem;

// root/ contains a viewer. A secret file outside must not be accessible.
class WebFilesTest : public testing::Test {
protected:
    void SetUp() override {
        fs::create_directories(folder_ / "root/assets");
        fs::create_directories(folder_ / "root2");
        write("secret.txt", "secret");
        write("root2/secret.txt", "secret");
        write("root/index.html", "<title>viewer</title>");
        write("root/assets/main-abc.js", "run()");
        write("root/.hidden", "secret");
        fs::create_symlink(folder_ / "secret.txt", folder_ / "root/link.txt");
    }
    void write(const std::string& name, const std::string& text) {
        std::ofstream(folder_ / name) << text;
    }
    HttpResponse get(const std::string& target, const std::string& if_none_match = {}) const {
        HttpRequest request;
        request.method = "GET";
        request.target = target;
        request.if_none_match = if_none_match;
        return WebFiles(folder_ / "root").serve(request);
    }
    static std::string header(const HttpResponse& response, const std::string& name) {
        for (const auto& [key, value] : response.headers) {
            if (key == name) return value;
        }
        return {};
    }

    const test::TempFolder temporary_;
    const fs::path folder_ = temporary_ / "";
};

TEST_F(WebFilesTest, serves_the_viewer_with_type_and_cache_headers) {
    const HttpResponse page = get("/");
    EXPECT_EQ(page.status, 200);
    EXPECT_EQ(page.body, "<title>viewer</title>");
    EXPECT_EQ(page.content_type, "text/html; charset=utf-8");
    EXPECT_EQ(header(page, "Cache-Control"), "no-cache");
    const HttpResponse script = get("/assets/main-abc.js?v=1");
    EXPECT_EQ(script.status, 200);
    EXPECT_EQ(script.content_type, "text/javascript; charset=utf-8");
    EXPECT_EQ(header(script, "Cache-Control"), "public, max-age=31536000, immutable");
}

TEST_F(WebFilesTest, returns_304_for_a_current_copy) {
    const std::string etag = header(get("/"), "ETag");
    ASSERT_FALSE(etag.empty());
    const HttpResponse again = get("/", etag);
    EXPECT_EQ(again.status, 304);
    EXPECT_TRUE(again.body.empty());
    write("root/index.html", "<title>a longer viewer</title>");
    EXPECT_EQ(get("/", etag).status, 200);
}

TEST_F(WebFilesTest, serves_the_smallest_copy_that_the_client_accepts) {
    write("root/assets/main-abc.js.br", "BR");
    write("root/assets/main-abc.js.gz", "GZIP");
    const auto ask = [&](const std::string& accepted, const std::string& etag = {}) {
        HttpRequest request;
        request.method = "GET";
        request.target = "/assets/main-abc.js";
        request.accept_encoding = accepted;
        request.if_none_match = etag;
        return WebFiles(folder_ / "root").serve(request);
    };
    const HttpResponse brotli = ask("gzip, deflate, br");
    EXPECT_EQ(brotli.body, "BR");
    EXPECT_EQ(header(brotli, "Content-Encoding"), "br");
    EXPECT_EQ(header(brotli, "Vary"), "Accept-Encoding");
    EXPECT_EQ(brotli.content_type, "text/javascript; charset=utf-8");
    EXPECT_EQ(header(brotli, "Cache-Control"), "public, max-age=31536000, immutable");
    const HttpResponse gzip = ask("gzip;q=0.5");
    EXPECT_EQ(gzip.body, "GZIP");
    EXPECT_EQ(header(gzip, "Content-Encoding"), "gzip");
    const HttpResponse plain = ask("");
    EXPECT_EQ(plain.body, "run()");
    EXPECT_EQ(header(plain, "Content-Encoding"), "");
    EXPECT_EQ(header(plain, "Vary"), "Accept-Encoding");
    EXPECT_NE(header(plain, "ETag"), header(gzip, "ETag"));
    EXPECT_NE(header(brotli, "ETag"), header(gzip, "ETag"));
    const HttpResponse current = ask("br", header(brotli, "ETag"));
    EXPECT_EQ(current.status, 304);
    EXPECT_EQ(header(current, "Vary"), "Accept-Encoding");
    EXPECT_EQ(ask("gzip", header(brotli, "ETag")).status, 200);
}

TEST_F(WebFilesTest, does_not_serve_a_copy_outside_the_root) {
    fs::create_symlink(folder_ / "secret.txt", folder_ / "root/index.html.gz");
    HttpRequest request;
    request.method = "GET";
    request.target = "/";
    request.accept_encoding = "gzip";
    EXPECT_EQ(WebFiles(folder_ / "root").serve(request).body, "<title>viewer</title>");
}

TEST(AcceptEncoding, reads_names_weights_and_wildcards) {
    EXPECT_TRUE(accepts_coding("br", "br"));
    EXPECT_TRUE(accepts_coding("gzip , BR ; q=0.1", "br"));
    EXPECT_TRUE(accepts_coding("*", "gzip"));
    EXPECT_FALSE(accepts_coding("", "gzip"));
    EXPECT_FALSE(accepts_coding("identity", "gzip"));
    EXPECT_FALSE(accepts_coding("gzip;q=0", "gzip"));
    EXPECT_FALSE(accepts_coding("*, gzip;q=0.000", "gzip"));
    EXPECT_FALSE(accepts_coding("xbr, brx", "br"));
    EXPECT_FALSE(accepts_coding(";;;,,=,q=0", "br"));
}

TEST_F(WebFilesTest, rejects_paths_outside_the_root) {
    const char* targets[] = {"/../secret.txt",
                             "/%2e%2e/secret.txt",
                             "/%2e%2e%2fsecret.txt",
                             "/assets/../../secret.txt",
                             "/assets/..%2f..%2fsecret.txt",
                             "//secret.txt",
                             "/..\\secret.txt",
                             "/..%5csecret.txt",
                             "/link.txt",
                             "/.hidden",
                             "/assets/../.hidden",
                             "/../root2/secret.txt",
                             "/%",
                             "/%zz",
                             "/%00",
                             "/index.html%00.png",
                             "secret.txt",
                             "",
                             "http://x/secret.txt",
                             "/%252e%252e/secret.txt"};
    for (const char* target : targets) {
        const HttpResponse response = get(target);
        EXPECT_TRUE(response.status == 400 || response.status == 404) << target;
        EXPECT_EQ(response.body.find("secret"), std::string::npos) << target;
    }
    EXPECT_EQ(get("/" + std::string(2000, 'x')).status, 400);
}

TEST_F(WebFilesTest, allows_only_get_and_head) {
    HttpRequest request;
    request.method = "PUT";
    request.target = "/index.html";
    const HttpResponse response = WebFiles(folder_ / "root").serve(request);
    EXPECT_EQ(response.status, 405);
    EXPECT_EQ(header(response, "Allow"), "GET, HEAD");
}

TEST_F(WebFilesTest, explains_a_missing_viewer_build) {
    HttpRequest request;
    request.method = "GET";
    request.target = "/";
    const HttpResponse response = WebFiles(folder_ / "nowhere").serve(request);
    EXPECT_EQ(response.status, 404);
    EXPECT_NE(response.body.find("--web-root"), std::string::npos);
    EXPECT_EQ(get("/no_such_file.js").body, "There is no such file.\n");
}

}  // namespace
}  // namespace jostle::server
