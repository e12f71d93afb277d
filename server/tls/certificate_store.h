// SPDX-License-Identifier: MIT
//
// The certificates in force. An operator replaces files while the server runs (a new certificate, a
// link that Kubernetes swaps), not always both at once and not always good ones. The store reads
// what has changed, and takes it over only when all of it is good (tls_material.h); else the old
// stays in force.
//
// Both listeners take it from here. (gRPC would read the files by itself, and break every handshake
// on a pair that does not fit.)
//
// material() and expiry() from any thread; poll() and reload() from whoever keeps time.
#pragma once

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

    // The files must be good the first time.
    static Result<std::unique_ptr<CertificateStore>> open(TlsSettings files, WallTime now);

    std::shared_ptr<const TlsMaterial> material() const;
    // When the first certificate of the chain in force expires.
    WallTime expiry() const { return material()->expires; }

    // Looks at most once a second whether a file has changed, and reads them all if so. `refused`
    // was logged with its reason, once for each change; what is only wrong for now (it is good from
    // tomorrow) is tried again every minute.
    Change poll(WallTime now);
    // Reads them now (SIGHUP).
    Change reload(WallTime now);

private:
    using Stamps = std::array<FileStamp, 3>;

    explicit CertificateStore(TlsSettings files) : files_(std::move(files)) {}

    Stamps stamps() const;
    Status read(WallTime now);
    Change read_and_log(WallTime now);

    const TlsSettings files_;
    mutable std::mutex mutex_;  // of material_
    std::shared_ptr<const TlsMaterial> material_;
    std::mutex reading_;   // of what follows
    Stamps stamps_;        // of the files when they were last read, good or not
    std::string refusal_;  // why what was last read is not in force; empty: it is
    WallTime last_poll_, last_read_;
};

}  // namespace jostle::server
