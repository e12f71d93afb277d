// SPDX-License-Identifier: MIT
//
// The certificates in force. An operator replaces files while the server runs (a new certificate, a
// symbolic link that Kubernetes swaps), not always all at once and not always with valid ones. The
// store reloads changed files and applies them only if all of them are valid (tls_material.h);
// otherwise the previous ones stay in force.
//
// Both listeners use this store. (gRPC would load the files itself, and a certificate that does not
// match its key would break every handshake.)
//
// material() and expiry() may be called from any thread; poll() and reload() from the maintenance
// thread.
#pragma once
#include <openssl/ssl.h>

#include <array>
#include <memory>
#include <mutex>
#include <string>

#include "server/tls/tls_material.h"
#include "server/util/watched_file.h"

namespace jostle::server {

class CertificateStore {
public:
    enum class Change { none, taken, refused };

    // The files must be valid at the first load.
    static Result<std::unique_ptr<CertificateStore>> open(TlsSettings files, WallTime now);

    std::shared_ptr<const TlsMaterial> material() const;
    // Expiry time of the first certificate in the chain to expire.
    WallTime expiry() const { return material()->expires; }

    // Checks for changed files at most once per second, and reloads all of them if one changed.
    // `refused` is logged with its reason, once per change. Files that are rejected are retried
    // every minute, because the fault may be temporary (not valid until tomorrow).
    Change poll(WallTime now);
    // Reloads now (SIGHUP).
    Change reload(WallTime now);

private:
    using Stamps = std::array<FileStamp, 3>;

    explicit CertificateStore(TlsSettings files) : files_(std::move(files)) {}

    Stamps stamps() const;
    Status read(WallTime now);
    Change read_and_log(WallTime now);

    const TlsSettings files_;
    mutable std::mutex mutex_;  // guards material_
    std::shared_ptr<const TlsMaterial> material_;
    std::mutex reading_;   // guards the members below
    Stamps stamps_;        // of the files at the last read, valid or not
    std::string refusal_;  // why the files of the last read are not in force; empty: they are
    WallTime last_poll_, last_read_;
};

// The subject, such as "CN=ops,O=Example" (RFC 2253), if TLS has verified it; empty: no
// certificate.
std::string verified_subject(const SSL* connection);

}  // namespace jostle::server
