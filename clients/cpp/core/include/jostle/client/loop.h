// SPDX-License-Identifier: MIT
//
// The network thread of clients: it connects them and reads and writes their messages.
#pragma once

#include <memory>

namespace jostle::client {

class LoopThread;

/// One thread for any number of clients. It must outlive its clients.
class Loop {
public:
    Loop();
    ~Loop();  ///< cancels the open streams and joins the thread
    Loop(const Loop&) = delete;
    Loop& operator=(const Loop&) = delete;

private:
    friend class Client;
    std::unique_ptr<LoopThread> thread_;
};

}  // namespace jostle::client
