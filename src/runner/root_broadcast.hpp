/// Work of rank 0 for all: its text reaches every rank, and its failure is every rank's.
#pragma once

#include <string>

#include "core/error.hpp"
#include "parallel/communicator.hpp"

namespace overturn {

/// A SystemError that every rank throws at the same place, so that one may report it and all end with the same code.
class CollectiveError : public SystemError {
  public:
    using SystemError::SystemError;
};

/// Runs `action` on rank 0 and gives its text to all. Collective.
/// \throws InputError, CollectiveError on every rank where `action` throws InputError, SystemError
template <class Action> std::string broadcast_from_root(parallel::Communicator const& comm, Action&& action) {
    constexpr char fine = '+';
    constexpr char bad_input = '-';
    constexpr char failed = '!';
    std::string text;
    if (comm.is_root()) {
        try {
            text = fine + action();
        } catch (InputError const& error) {
            text = bad_input + std::string(error.what());
        } catch (SystemError const& error) {
            text = failed + std::string(error.what());
        }
    }
    comm.broadcast(text);
    if (text.front() == bad_input) {
        throw InputError(text.substr(1));
    }
    if (text.front() == failed) {
        throw CollectiveError(text.substr(1));
    }
    return text.substr(1);
}

}  // namespace overturn
