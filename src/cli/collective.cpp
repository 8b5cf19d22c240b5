#include "cli/collective.hpp"

#include <exception>

#include "campaign/agreement.hpp"
#include "cli/command_line.hpp"
#include "cli/say.hpp"
#include "core/error.hpp"

namespace overturn::cli {

int on_all_ranks(std::function<int(parallel::Communicator const&)> const& action) {
    parallel::Environment const environment;
    parallel::Communicator const comm;
    try {
        return action(comm);
    } catch (InputError const& error) {
        if (comm.is_root()) {
            say(error.what());
        }
        return bad_input;
    } catch (AgreedError const& error) {
        if (comm.is_root()) {
            say(error.what());
        }
        return other_failure;
    } catch (std::exception const& error) {
        say(error.what());
        if (comm.size() > 1) {
            comm.abort(other_failure);
        }
        return other_failure;
    }
}

}  // namespace overturn::cli
