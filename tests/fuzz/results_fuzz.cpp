// Requirement: whatever bytes a results file holds, it is read or refused with InputError or SystemError.
#include <cstdio>
#include <cstdlib>

#include <unistd.h>

#include "results/recount.hpp"
#include "store/durable.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size);

namespace {

std::filesystem::path const& place() {
    static auto const path = std::filesystem::path(std::getenv("TMPDIR") == nullptr ? "/tmp" : std::getenv("TMPDIR"))
                             / ("overturn-fuzz-" + std::to_string(::getpid()) + ".h5");
    return path;
}

// What status, fit and replay read.
void read() {
    using namespace overturn;
    try {
        store::ResultsReader const file(place(), store::Trust::unverified);
        auto const input = input_of(file);
        (void)file.text("wave_acceptance");
        auto const spec = parse_campaign(input);
        (void)read_trial(file, spec, 0);
        (void)recount(file, spec);
    } catch (InputError const&) {
        return;
    } catch (SystemError const&) {
        return;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
    if (auto* const file = std::fopen(place().c_str(), "wb")) {
        (void)std::fwrite(data, 1, size, file);
        (void)std::fclose(file);
    }
    read();
    return 0;
}
