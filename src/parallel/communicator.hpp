/// The only room that calls MPI: who we are, bytes from rank to rank, and one counter that all ranks share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace overturn::parallel {

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

struct Message {
    int from = 0;
    std::vector<std::byte> bytes;
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

    /// Rank 0's text, on every rank. Collective.
    void broadcast(std::string& text) const;
    /// The texts of all ranks in rank order on rank 0, empty elsewhere. Collective.
    [[nodiscard]] std::vector<std::string> gather(std::string const& text) const;
    /// The largest of all ranks' values. Collective.
    [[nodiscard]] int largest(int value) const;

    /// A message that has arrived, or nothing. Also gives MPI time to serve the other ranks.
    [[nodiscard]] std::optional<Message> poll() const;
    /// Waits for a message.
    [[nodiscard]] Message receive() const;

    /// Ends every rank at once; for an error only one rank knows of.
    [[noreturn]] void abort(int code) const;

  private:
    int rank_ = 0;
    int size_ = 1;
};

/// Messages on their way to rank 0, so that a rank computes on while rank 0 is busy. Destruction waits for all of them.
class Outbox {
  public:
    Outbox();
    ~Outbox();
    Outbox(Outbox const&) = delete;
    Outbox& operator=(Outbox const&) = delete;
    Outbox(Outbox&&) = delete;
    Outbox& operator=(Outbox&&) = delete;

    /// Sends bytes; waits only while too many earlier messages are still under way.
    void post(std::vector<std::byte> bytes);

  private:
    struct Letter;
    void deliver(std::size_t most_left);
    std::deque<Letter> letters_;
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

  private:
    struct Window;
    std::unique_ptr<Window> window_;
};

}  // namespace overturn::parallel
