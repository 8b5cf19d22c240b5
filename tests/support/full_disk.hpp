/// A disk that is full beyond a file size, for as long as this object lives.
#pragma once

#include <csignal>

#include <sys/resource.h>

namespace overturn::testing {

class FullDisk {
  public:
    explicit FullDisk(rlim_t largest_file_bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        rlimit const tight{largest_file_bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &tight);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FullDisk(FullDisk const&) = delete;
    FullDisk& operator=(FullDisk const&) = delete;
    FullDisk(FullDisk&&) = delete;
    FullDisk& operator=(FullDisk&&) = delete;

  private:
    rlimit before_{};
    void (*handler_)(int);
};

}  // namespace overturn::testing
