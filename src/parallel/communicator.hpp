/// The only room that calls MPI: who we are, texts from and to rank 0, and counters that all ranks share.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace overturn::parallel {

/// Whether a launcher started this process in a way that MPI can join: mpirun, or srun with a PMI.
bool is_launched();

/// MPI for the lifetime of this object; make one, in main, before anything that communicates.
class Environment {
  public:
    Environment();
    ~Environment();
    Environment(Environment const&) = delete;
    Environment& operator=(Environment const&) = delete;
    Environment(Environment&&) = delete;
    Environment& operator=(Environment&&) = delete;
};

/// All ranks of the job.
class Communicator {
  public:
    Communicator();

    [[nodiscard]] int rank() const { return rank_; }
    [[nodiscard]] int size() const { return size_; }
    [[nodiscard]] bool is_root() const { return rank_ == 0; }
    /// The machine this rank runs on; for the reader only.
    [[nodiscard]] std::string host() const;

    /// "Open MPI v4.1.4"; for the reader only.
    [[nodiscard]] static std::string library();

    /// Rank 0's text, on every rank. Collective.
    void broadcast(std::string& text) const;
    /// The texts of all ranks in rank order on rank 0, empty elsewhere. Collective.
    [[nodiscard]] std::vector<std::string> gather(std::string const& text) const;
    /// The largest of all ranks' values. Collective.
    [[nodiscard]] int largest(int value) const;

    /// Gives MPI a moment to serve other ranks; for long work on the rank that holds a shared counter.
    void serve() const;
    /// Waits until every rank has come here, without burning its core; `meanwhile` runs now and then. Collective.
    void wait_for_all(std::function<void()> const& meanwhile) const;

    /// Ends every rank at once; for an error only one rank knows of.
    [[noreturn]] void abort(int code) const;

  private:
    int rank_ = 0;
    int size_ = 1;
};

/// A number on rank 0 from which every rank takes the next value. Construction and destruction are collective.
class SharedCounter {
  public:
    explicit SharedCounter(Communicator const& comm);
    ~SharedCounter();
    SharedCounter(SharedCounter const&) = delete;
    SharedCounter& operator=(SharedCounter const&) = delete;
    SharedCounter(SharedCounter&&) = delete;
    SharedCounter& operator=(SharedCounter&&) = delete;

    /// The value before adding `step`; no two calls anywhere return the same for step 1.
    [[nodiscard]] std::int64_t take(std::int64_t step = 1);
    /// The value now.
    [[nodiscard]] std::int64_t look() { return take(0); }

  private:
    struct Window;
    std::unique_ptr<Window> window_;
};

}  // namespace overturn::parallel
