#include <cstdlib>
#include <filesystem>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "campaign/version.hpp"
#include "cli/collective.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "qualify/installation.hpp"
#include "qualify/known_answers.hpp"
#include "qualify/page.hpp"
#include "qualify/published.hpp"
#include "runner/root_broadcast.hpp"
#include "store/durable.hpp"

namespace overturn::cli {
namespace {

namespace fs = std::filesystem;

struct QualifyOptions {
    std::string folder = ".";
    std::optional<std::string> page;
    bool published = false;
    bool json = false;
    std::string date;
};

// A folder of this run's own on the file system in question, for all ranks, gone with it.
class Bench {
  public:
    Bench(fs::path const& where, parallel::Communicator const& comm) : root_(comm.is_root()) {
        folder_ = broadcast_from_root(comm, [&] {
            store::require_writable(where / "output");
            auto name = (fs::absolute(where) / "overturn-qualify-XXXXXX").string();
            if (::mkdtemp(name.data()) == nullptr) {
                throw SystemError(fmt::format("{} (no folder can be made there). Name another", where.string()));
            }
            return name;
        });
    }
    ~Bench() {
        std::error_code ignored;
        if (root_) {
            fs::remove_all(folder_, ignored);
        }
    }
    Bench(Bench const&) = delete;
    Bench& operator=(Bench const&) = delete;
    Bench(Bench&&) = delete;
    Bench& operator=(Bench&&) = delete;

    [[nodiscard]] fs::path const& folder() const { return folder_; }

  private:
    fs::path folder_;
    bool root_;
};

int print_outcome(QualifyOptions const& options, qualify::Qualification const& shown) {
    if (options.page) {
        store::write_durably(*options.page, qualify::page_of(shown));
    }
    fmt::print("{}", options.json ? qualify::json_of(shown).dump(2) + "\n" : qualify::text_of(shown));
    return shown.passed() ? done : other_failure;
}

qualify::Checks installation_checks(fs::path const& folder, qualify::Checks const& campaign) {
    qualify::Checks all;
    for (auto const& part : {qualify::mechanics(), qualify::contact(), qualify::spectra(), qualify::numbers(), campaign,
                             qualify::file_system_checks(folder)}) {
        all.insert(all.end(), part.begin(), part.end());
    }
    return all;
}

int qualify_here(QualifyOptions const& options, parallel::Communicator const& comm) {
    (void)broadcast_from_root(comm, [&] {
        if (options.page) {
            store::require_writable(*options.page);
        }
        return std::string();
    });
    std::optional<Bench> bench;
    if (!options.published) {
        bench.emplace(options.folder, comm);
    }
    auto const campaign = bench ? qualify::campaign_checks(bench->folder(), comm) : qualify::Checks{};
    return std::stoi(broadcast_from_root(comm, [&] {
        qualify::Qualification const shown{
            .checks = bench ? installation_checks(bench->folder(), campaign) : qualify::published(),
            .left_out = bench ? std::vector<qualify::LeftOut>{} : qualify::left_out_of_published(),
            .program = program_identity(),
            .machine = machine(),
            .compiler = compiler(),
            .libraries = library_versions(),
            .mpi = parallel::Communicator::library(),
            .folder = fs::absolute(options.folder).lexically_normal().string(),
            .ranks = comm.size(),
            .date = options.date,
            .published = options.published};
        return fmt::format("{}", print_outcome(options, shown));
    }));
}

}  // namespace

void add_qualify(CommandLine& line) {
    auto verb = line.verb("qualify", "compare this installation with known answers, alone or under mpirun");
    auto options = std::make_shared<QualifyOptions>();
    verb.takes("folder", options->folder, "folder for results, whose file system is checked too; default: here");
    verb.takes("--published", options->published, "compare the program with published results instead");
    verb.takes("--html", options->page, "write the record as a page (no network needed)");
    verb.takes("--json", options->json, "print the record as JSON, to be filed or read by scripts");
    verb.takes("--date", options->date, "date printed on the record, exactly as given; default: none");
    verb.does([options] { return on_all_ranks([&](auto const& comm) { return qualify_here(*options, comm); }); });
}

}  // namespace overturn::cli
