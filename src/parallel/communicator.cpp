#include "parallel/communicator.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <exception>

#if __has_include(<execinfo.h>)
#include <execinfo.h>
#endif

#include <fmt/format.h>
#include <mpi.h>

#include "parallel/detail/check.hpp"
#include "parallel/pause.hpp"

namespace overturn::parallel {
namespace {

void wait_for(MPI_Request& request, char const* what, std::function<void()> const& meanwhile = {}) {
    for (Pause pause;; pause()) {
        int done = 0;
        check(MPI_Test(&request, &done, MPI_STATUS_IGNORE), what);
        if (done != 0) {
            return;
        }
        if (meanwhile) {
            meanwhile();
        }
    }
}

void broadcast_bytes(void* bytes, int count, MPI_Datatype type) {
    MPI_Request request = MPI_REQUEST_NULL;
    check(MPI_Ibcast(bytes, count, type, 0, MPI_COMM_WORLD, &request), "broadcasting");
    wait_for(request, "broadcasting");
}

}  // namespace

bool is_launched() {
    static constexpr std::array names{"PMIX_RANK", "PMI_RANK", "PMI_FD", "OMPI_COMM_WORLD_SIZE"};
    return std::ranges::any_of(names, [](char const* name) { return std::getenv(name) != nullptr; });
}

Environment::Environment() {
    // Open MPI 4.1's first choice for one-sided calls cannot make a window over TCP ("invalid window"); its others can.
    ::setenv("OMPI_MCA_osc", "^rdma", 0);
    if (!is_launched()) {
        // It needs no daemon beside it: Open MPI's takes a third of a small run's CPU time.
        ::setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
        // Nor a folder: all processes of a user share its parent, and one that ends removes it while another one makes
        // its own ("orte_session_dir failed", 1 of 300 starts beside seven others).
        ::setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
        // Nor a network, and it talks to itself only. Libraries of fabrics (PSM2) measure the clock for 0.1 s.
        ::setenv("OMPI_MCA_pml", "ob1", 0);
        ::setenv("OMPI_MCA_btl", "self", 0);
    }
    // UCX's handler of a crash frees memory: where the heap is what crashed, it waits for ever.
    ::setenv("UCX_HANDLE_ERRORS", "none", 0);
#if __has_include(<execinfo.h>)
    // On SIGABRT Open MPI prints where it came from. The first backtrace of a process loads a library, and that
    // allocates: within an abort of malloc's own it waits for ever for what the abort holds. So the first is here.
    std::array<void*, 1> here{};
    (void)::backtrace(here.data(), 1);
#endif
    int provided = 0;
    check(MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided), "starting up");
}

Environment::~Environment() { MPI_Finalize(); }

Communicator::Communicator() {
    check(MPI_Comm_rank(MPI_COMM_WORLD, &rank_), "asking for the rank");
    check(MPI_Comm_size(MPI_COMM_WORLD, &size_), "asking for the size");
}

std::string Communicator::host() const {
    std::array<char, MPI_MAX_PROCESSOR_NAME> name{};
    int length = 0;
    check(MPI_Get_processor_name(name.data(), &length), "asking for the host");
    return {name.data(), static_cast<std::size_t>(length)};
}

std::string Communicator::library() {
    std::array<char, MPI_MAX_LIBRARY_VERSION_STRING> name{};
    int length = 0;
    check(MPI_Get_library_version(name.data(), &length), "asking for its version");
    std::string const text(name.data(), length);
    auto line = text.substr(0, text.find_first_of(",\n"));
    std::replace(line.begin(), line.end(), '\t', ' ');  // MPICH's pages of text begin with "MPICH Version:<tab>4.0.2"
    return line;
}

void Communicator::broadcast(std::string& text) const {
    std::int64_t size = text.size();
    broadcast_bytes(&size, 1, MPI_INT64_T);
    text.resize(size);
    constexpr std::int64_t most = 1 << 30;  // a count is an int
    for (std::int64_t at = 0; at < size; at += most) {
        auto const part = static_cast<int>(std::min(most, size - at));
        broadcast_bytes(text.data() + at, part, MPI_CHAR);
    }
}

std::vector<std::string> Communicator::gather(std::string const& text) const {
    int const length = static_cast<int>(text.size());
    std::vector<int> lengths(is_root() ? static_cast<std::size_t>(size_) : 0);
    MPI_Request request = MPI_REQUEST_NULL;
    check(MPI_Igather(&length, 1, MPI_INT, lengths.data(), 1, MPI_INT, 0, MPI_COMM_WORLD, &request), "gathering");
    wait_for(request, "gathering");
    std::vector<int> places;
    std::string all;
    int total = 0;
    for (int const l : lengths) {
        places.push_back(total);
        total += l;
    }
    all.resize(total);
    check(MPI_Igatherv(text.data(), length, MPI_CHAR, all.data(), lengths.data(), places.data(), MPI_CHAR, 0,
                       MPI_COMM_WORLD, &request),
          "gathering");
    wait_for(request, "gathering");
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        texts.push_back(all.substr(places[i], lengths[i]));
    }
    return texts;
}

int Communicator::largest(int value) const {
    int result = value;
    MPI_Request request = MPI_REQUEST_NULL;
    check(MPI_Iallreduce(&value, &result, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD, &request), "comparing");
    wait_for(request, "comparing");
    return result;
}

void Communicator::serve() const {
    int found = 0;
    check(MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &found, MPI_STATUS_IGNORE), "serving");
}

void Communicator::wait_for_all(std::function<void()> const& meanwhile) const {
    MPI_Request request = MPI_REQUEST_NULL;
    check(MPI_Ibarrier(MPI_COMM_WORLD, &request), "waiting for all");
    wait_for(request, "waiting for all", meanwhile);
}

void Communicator::abort(int code) const {
    MPI_Abort(MPI_COMM_WORLD, code);
    std::abort();
}

// One-sided, so that a rank takes its next piece without waiting for rank 0 to look up from its own.
struct SharedCounter::Window {
    MPI_Win handle = MPI_WIN_NULL;
    std::int64_t* value = nullptr;
};

SharedCounter::SharedCounter(Communicator const& comm) : window_(std::make_unique<Window>()) {
    MPI_Aint const bytes = comm.is_root() ? sizeof(std::int64_t) : 0;
    check(MPI_Win_allocate(bytes, sizeof(std::int64_t), MPI_INFO_NULL, MPI_COMM_WORLD,
                           static_cast<void*>(&window_->value), &window_->handle),
          "making the shared counter");
    if (comm.is_root()) {
        check(MPI_Win_lock(MPI_LOCK_EXCLUSIVE, 0, 0, window_->handle), "locking the shared counter");
        *window_->value = 0;
        check(MPI_Win_unlock(0, window_->handle), "unlocking the shared counter");
    }
    check(MPI_Barrier(MPI_COMM_WORLD), "waiting for the shared counter");
}

SharedCounter::~SharedCounter() {
    if (std::uncaught_exceptions() == 0) {  // else the others may never come here, and freeing would wait for them
        MPI_Win_free(&window_->handle);
    }
}

std::int64_t SharedCounter::take(std::int64_t step) {
    std::int64_t before = 0;
    check(MPI_Win_lock(MPI_LOCK_SHARED, 0, 0, window_->handle), "locking the shared counter");
    check(MPI_Fetch_and_op(&step, &before, MPI_INT64_T, 0, 0, MPI_SUM, window_->handle), "taking from the counter");
    check(MPI_Win_unlock(0, window_->handle), "unlocking the shared counter");
    return before;
}

}  // namespace overturn::parallel
