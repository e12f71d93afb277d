// SPDX-License-Identifier: MIT
#include "jostle/client/security.h"
#include "clients/cpp/core/src/security.h"

#include <filesystem>
#include <fstream>
#include <iterator>

namespace jostle::client {

namespace {

constexpr std::size_t file_bytes_max = 1u << 20;

bool is_loopback(const std::string& target) {
    const std::string host = target.substr(0, target.rfind(':'));
    const bool is_ipv4 = host.find_first_not_of("0123456789.") == std::string::npos;
    return host == "localhost" || (is_ipv4 && host.starts_with("127.")) || host == "[::1]";
}

Status read_text(const std::string& path, std::string& out) {
    std::error_code ignored;
    std::ifstream file(path, std::ios::binary);
    if (!file || std::filesystem::is_directory(path, ignored))
        return invalid_argument("cannot read " + path +
                                ": the file does not exist or is not readable");
    out.resize(file_bytes_max + 1);
    file.read(out.data(), static_cast<std::streamsize>(out.size()));
    out.resize(static_cast<std::size_t>(file.gcount()));
    if (out.size() > file_bytes_max)
        return invalid_argument(path + " is too large; at most 1 MiB is accepted");
    return {};
}

// Does nothing without a path.
Status read_pem(const std::string& path, std::string& out) {
    if (path.empty()) return {};
    if (Status s = read_text(path, out); !s.ok()) return s;
    if (out.find("-----BEGIN ") == std::string::npos)
        return invalid_argument(path + " is not a PEM file: it has no -----BEGIN ...----- line");
    return {};
}

Status read_token(const std::string& path, std::string& out) {
    if (path.empty()) return {};
    if (Status s = read_text(path, out); !s.ok()) return s;
    // Removes the line end that editors append.
    out.erase(out.find_last_not_of("\r\n ") + 1);
    return out.empty() ? invalid_argument(path + " contains no token") : Status();
}

}  // namespace

Result<Security> read_security(const SecurityFiles& files, const std::string& target) {
    Security security;
    if (files.certificate.empty() != files.key.empty())
        return invalid_argument("--cert and --key must be given together");
    security.tls = files.tls || !files.certificate.empty() || !files.root_certificates.empty();
    for (const auto& [path, out] :
         {std::pair(&files.root_certificates, &security.root_certificates_pem),
          std::pair(&files.certificate, &security.certificate_pem),
          std::pair(&files.key, &security.key_pem)})
        if (Status s = read_pem(*path, *out); !s.ok()) return s.error();
    if (Status s = read_token(files.token, security.token); !s.ok()) return s.error();
    if (!security.token.empty() && !security.tls && !is_loopback(target))
        return invalid_argument(
            "a token requires TLS unless the server is on loopback; use --tls, or --ca FILE for a "
            "private CA");
    return security;
}

std::shared_ptr<grpc::ChannelCredentials> channel_credentials(const Security& security) {
    if (!security.tls) return grpc::InsecureChannelCredentials();
    grpc::SslCredentialsOptions options;
    options.pem_root_certs = security.root_certificates_pem;
    options.pem_cert_chain = security.certificate_pem;
    options.pem_private_key = security.key_pem;
    return grpc::SslCredentials(options);
}

void attach_token(grpc::ClientContext& call, const Security& security) {
    if (!security.token.empty()) call.AddMetadata("authorization", "Bearer " + security.token);
}

}  // namespace jostle::client
