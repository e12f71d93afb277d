// SPDX-License-Identifier: MIT
#include "server/http/beast_request.h"

#include <gtest/gtest.h>

#include <boost/asio/buffer.hpp>
#include <string>

namespace jostle::server {
namespace {

// "" if the header is accepted; "Beast" if the parser rejects it; otherwise the fault.
std::string fault_of(const std::string& header) {
    if (has_folded_header(header)) return "folded";
    BeastRequestParser parser;
    set_limits(parser, HttpServerSettings{});
    boost::beast::error_code error;
    parser.put(boost::asio::buffer(header), error);
    if (error == boost::beast::http::error::need_more) return "incomplete";
    if (error) return "Beast";
    if (!parser.is_header_done()) return "incomplete";
    return std::string(request_fault(parser.get()).value_or(""));
}

std::string get(const std::string& headers, const char* version = "1.1") {
    return std::string("GET / HTTP/") + version + "\r\n" + headers + "\r\n";
}

struct Case {
    const char* name;
    std::string header;
};

TEST(BeastRequest, accepts_ordinary_requests) {
    const Case cases[] = {
        {"name", get("Host: play.example.org\r\n")},
        {"port", get("Host: localhost:8080\r\n")},
        {"address", get("Host: 192.0.2.7:1\r\n")},
        {"IPv6", get("Host: [2001:db8::1]:8080\r\n")},
        {"mixed case", get("hOsT: Play_1.Example.ORG.\r\n")},
        {"spaces around a value", get("Host:  a \r\nX-A:\tb\t\r\n")},
        {"HTTP/1.0 without Host", get("", "1.0")},
        {"length", "POST / HTTP/1.1\r\nHost: a\r\nContent-Length: 0\r\n\r\n"},
        {"chunked, which the session refuses with 411",
         "POST / HTTP/1.1\r\nHost: a\r\nTransfer-Encoding: chunked\r\n\r\n"},
        {"absolute target", "GET http://b/c?d=e HTTP/1.1\r\nHost: a\r\n\r\n"},
        {"asterisk", "OPTIONS * HTTP/1.1\r\nHost: a\r\n\r\n"},
        {"UTF-8 in a value", get("Host: a\r\nX-Name: J\xc3\xb8rn\r\n")},
        {"upgrade",
         get("Host: a\r\nConnection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
             "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n")},
    };
    for (const Case& c : cases) EXPECT_EQ(fault_of(c.header), "") << c.name;
}

TEST(BeastRequest, rejects_ambiguous_and_invalid_requests) {
    const std::string host = "Host: a\r\n";
    const auto with = [&](const std::string& headers) { return get(host + headers); };
    const std::string nul("\0", 1);
    const Case cases[] = {
        {"no Host", get("")},
        {"two Hosts", get("Host: a\r\nHost: b\r\n")},
        {"the same Host twice", get("Host: a\r\nhost: a\r\n")},
        {"two Hosts in HTTP/1.0", get("Host: a\r\nHost: a\r\n", "1.0")},
        {"empty Host", get("Host:\r\n")},
        {"list of Hosts", get("Host: a, b\r\n")},
        {"user in Host", get("Host: me@a\r\n")},
        {"path in Host", get("Host: a/b\r\n")},
        {"space in Host", get("Host: a b\r\n")},
        {"encoded Host", get("Host: %61\r\n")},
        {"port with letters", get("Host: a:8o\r\n")},
        {"port beyond 65535", get("Host: a:65536\r\n")},
        {"two ports", get("Host: a:1:2\r\n")},
        {"IPv6 without brackets", get("Host: ::1\r\n")},
        {"IPv6 that is none", get("Host: [1::2::3]\r\n")},
        {"IPv6 without its end", get("Host: [::1\r\n")},
        {"text after IPv6", get("Host: [::1]a\r\n")},
        {"long Host", get("Host: " + std::string(256, 'a') + "\r\n")},
        {"length and coding", with("Content-Length: 5\r\nTransfer-Encoding: chunked\r\n")},
        {"coding and length", with("Transfer-Encoding: chunked\r\nContent-Length: 5\r\n")},
        {"coding in HTTP/1.0", get(host + "Transfer-Encoding: chunked\r\n", "1.0")},
        {"unknown coding", with("Transfer-Encoding: gzip\r\n")},
        {"two codings", with("Transfer-Encoding: gzip, chunked\r\n")},
        {"chunked twice", with("Transfer-Encoding: chunked, chunked\r\n")},
        {"identity", with("Transfer-Encoding: identity\r\n")},
        {"empty coding", with("Transfer-Encoding:\r\n")},
        {"repeated coding", with("Transfer-Encoding: chunked\r\nTransfer-Encoding: chunked\r\n")},
        {"obfuscated: x", with("Transfer-Encoding: xchunked\r\n")},
        {"obfuscated: quotes", with("Transfer-Encoding: \"chunked\"\r\n")},
        {"obfuscated: case", with("Transfer-Encoding: cHuNkEd\r\n")},
        {"obfuscated: vertical tab", with("Transfer-Encoding: \vchunked\r\n")},
        {"obfuscated: parameter", with("Transfer-Encoding: chunked;a=b\r\n")},
        {"obfuscated: folded", with("Transfer-Encoding:\r\n chunked\r\n")},
        {"obfuscated: comma", with("Transfer-Encoding: ,chunked\r\n")},
        {"two lengths", with("Content-Length: 0\r\nContent-Length: 5\r\n")},
        {"the same length twice", with("Content-Length: 5\r\nContent-Length: 5\r\n")},
        {"list of lengths", with("Content-Length: 5, 5\r\n")},
        {"signed length", with("Content-Length: +5\r\n")},
        {"negative length", with("Content-Length: -5\r\n")},
        {"hexadecimal length", with("Content-Length: 0x5\r\n")},
        {"length with text", with("Content-Length: 5a\r\n")},
        {"length with a space", with("Content-Length: 5 5\r\n")},
        {"empty length", with("Content-Length:\r\n")},
        {"length beyond 64 bits", with("Content-Length: 18446744073709551621\r\n")},
        {"space before the colon", with("X-A : b\r\n")},
        {"tab before the colon", with("X-A\t: b\r\n")},
        {"space before the colon of a length", with("Content-Length : 5\r\n")},
        {"space before the first header", get(" Host: a\r\n")},
        {"empty name", with(": b\r\n")},
        {"no colon", with("X-A\r\n")},
        {"folded line", with("X-A: b\r\n c\r\n")},
        {"bare LF after a header", get("Host: a\nX-A: b\r\n")},
        {"bare LF in a value", with("X-A: b\nX-B: c\r\n")},
        {"bare CR in a value", with("X-A: b\rX-B: c\r\n")},
        {"CR CR LF", with("X-A: b\r\r\n")},
        {"NUL in a value", with("X-A: b" + nul + "c\r\n")},
        {"NUL in a name", with("X" + nul + ": b\r\n")},
        {"control character", with("X-A: \x01\r\n")},
        {"delete character", with("X-A: \x7f\r\n")},
        {"NUL in the target", "GET /" + nul + " HTTP/1.1\r\n" + host + "\r\n"},
        {"bare LF after the request line", "GET / HTTP/1.1\n" + host + "\r\n"},
        {"two spaces", "GET  / HTTP/1.1\r\n" + host + "\r\n"},
        {"lower-case version", "GET / http/1.1\r\n" + host + "\r\n"},
        {"HTTP/0.9", "GET /\r\n\r\n"},
        {"HTTP/1.2", get(host, "1.2")},
        {"HTTP/2.0", get(host, "2.0")},
        {"absolute target without a host", "GET http:/// HTTP/1.1\r\n" + host + "\r\n"},
        {"absolute target with a user", "GET http://me@b/ HTTP/1.1\r\n" + host + "\r\n"},
        {"absolute target of another scheme", "GET ftp://b/ HTTP/1.1\r\n" + host + "\r\n"},
        {"absolute target without Host in HTTP/1.1", "GET http://b/ HTTP/1.1\r\n\r\n"},
        {"relative target", "GET index.html HTTP/1.1\r\n" + host + "\r\n"},
        {"asterisk in GET", "GET * HTTP/1.1\r\n" + host + "\r\n"},
        {"authority target", "CONNECT b:80 HTTP/1.1\r\n" + host + "\r\n"},
        {"two tokens", with("Authorization: Bearer a\r\nAuthorization: Bearer b\r\n")},
        {"two origins", with("Origin: http://a\r\nOrigin: http://b\r\n")},
        {"upgrade with a body",
         with("Connection: Upgrade\r\nUpgrade: websocket\r\nContent-Length: 5\r\n")},
    };
    for (const Case& c : cases) {
        EXPECT_NE(fault_of(c.header), "") << c.name;
        EXPECT_NE(fault_of(c.header), "incomplete") << c.name;
    }
}

// RFC 9112, 3.2.
TEST(BeastRequest, reads_every_form_of_a_target) {
    const auto forms = [](const char* method, const char* target) {
        const auto parsed = parse_target(method, target);
        return parsed ? parsed->authority + " " + parsed->path : "none";
    };
    EXPECT_EQ(forms("GET", "/a?b=c"), " /a?b=c");
    EXPECT_EQ(forms("GET", "http://b:8080/a?b=c"), "b:8080 /a?b=c");
    EXPECT_EQ(forms("GET", "HTTPS://B.example/"), "B.example /");
    EXPECT_EQ(forms("GET", "http://b"), "b /");
    EXPECT_EQ(forms("GET", "http://b?c"), "b /?c");
    EXPECT_EQ(forms("GET", "http://[::1]:1/x"), "[::1]:1 /x");
    EXPECT_EQ(forms("OPTIONS", "http://b"), "b *");
    EXPECT_EQ(forms("OPTIONS", "*"), " *");
    for (const char* target : {"", "*", "b", "b:80", "http:/b", "http://", "http://b c/"})
        EXPECT_EQ(forms("GET", target), "none") << target;
    EXPECT_EQ(forms("GET", "//b/"), " //b/") << "a path, whose first segment is empty";
}

TEST(BeastRequest, the_authority_of_a_uri_replaces_the_host_header) {
    BeastRequestParser parser;
    set_limits(parser, HttpServerSettings{});
    boost::beast::error_code error;
    parser.put(boost::asio::buffer(std::string(
                   "GET http://b:80/x HTTP/1.1\r\nHost: a\r\nX-Forwarded-For: 1.2.3.4\r\n"
                   "x-forwarded-for: 5.6.7.8\r\n\r\n")),
               error);
    const HttpRequest request = to_http_request(parser.get());
    EXPECT_EQ(request.host, "b:80");
    EXPECT_EQ(request.target, "/x");
    EXPECT_EQ(joined_header(parser.get(), "x-forwarded-for"), "1.2.3.4,5.6.7.8");
    EXPECT_EQ(joined_header(parser.get(), "forwarded"), "");
}

}  // namespace
}  // namespace jostle::server
