#include "parallel/letters.hpp"

#include <memory>
#include <set>

#include <mpi.h>

#include "parallel/detail/check.hpp"
#include "parallel/pause.hpp"

namespace overturn::parallel {
namespace {

constexpr int tag = 1;

}  // namespace

// MPI reads or writes the text until the request is done, so it stays where it is.
struct Letters::OnTheWay {
    Letter letter;
    MPI_Request request = MPI_REQUEST_NULL;

    [[nodiscard]] bool is_done() {
        int done = 0;
        check(MPI_Test(&request, &done, MPI_STATUS_IGNORE), "testing a letter");
        return done != 0;
    }
};

Letters::Letters() = default;

// Where an error ends the program letters may be on their way still, and MPI goes on to use them.
Letters::~Letters() {
    for (auto* const letters : {&sent_, &coming_}) {
        std::erase_if(*letters, [](OnTheWay& letter) {
            int done = 0;
            return MPI_Test(&letter.request, &done, MPI_STATUS_IGNORE) == MPI_SUCCESS && done != 0;
        });
        if (!letters->empty()) {
            (void)std::make_unique<std::list<OnTheWay>>(std::move(*letters)).release();
        }
    }
}

void Letters::send(int to, std::string text) {
    auto& sent = sent_.emplace_back(OnTheWay{{to, std::move(text)}});
    check(MPI_Isend(sent.letter.text.data(), static_cast<int>(sent.letter.text.size()), MPI_CHAR, to, tag,
                    MPI_COMM_WORLD, &sent.request),
          "sending a letter");
}

// A long one comes in pieces, which its sender may stop amid: so it is not waited for.
std::optional<Letter> Letters::take() {
    std::erase_if(sent_, [](OnTheWay& letter) { return letter.is_done(); });
    int found = 0;
    MPI_Message message = MPI_MESSAGE_NULL;
    MPI_Status status;
    check(MPI_Improbe(MPI_ANY_SOURCE, tag, MPI_COMM_WORLD, &found, &message, &status), "looking for letters");
    if (found != 0) {
        int length = 0;
        check(MPI_Get_count(&status, MPI_CHAR, &length), "asking for the length of a letter");
        auto& coming = coming_.emplace_back(OnTheWay{{status.MPI_SOURCE, std::string(length, '\0')}});
        check(MPI_Imrecv(coming.letter.text.data(), length, MPI_CHAR, &message, &coming.request), "taking a letter");
    }
    std::set<int> held;  // senders of one that is not there yet
    for (auto at = coming_.begin(); at != coming_.end(); ++at) {
        if (!held.contains(at->letter.from) && !at->is_done()) {
            held.insert(at->letter.from);
        } else if (!held.contains(at->letter.from)) {
            auto letter = std::move(at->letter);
            coming_.erase(at);
            return letter;
        }
    }
    return std::nullopt;
}

Letter Letters::wait() {
    for (Pause pause;; pause()) {
        if (auto letter = take()) {
            return std::move(*letter);
        }
    }
}

}  // namespace overturn::parallel
