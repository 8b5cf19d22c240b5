#include <filesystem>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <unistd.h>

#include "cli/named_files.hpp"
#include "cli/verbs.hpp"
#include "core/print_note.hpp"
#include "cost/sensitivity.hpp"
#include "cost/study_output.hpp"
#include "output/json.hpp"
#include "report/cost_page.hpp"
#include "report/sensitivity_page.hpp"
#include "runner/progress.hpp"
#include "store/durable.hpp"

namespace overturn::cli {
namespace {

struct CostOptions {
    std::string campaign, page;
    std::optional<std::string> output;
    std::vector<std::string> settings;
    std::optional<std::int64_t> waves;
    bool json = false;
    bool sensitivity = false;
};

/// One line that rewrites itself on a terminal, a few plain ones elsewhere.
class Remaining {
  public:
    void operator()(double done, double left_s) {
        constexpr double terminal_step = 0.01;
        constexpr double plain_step = 0.25;
        bool const last = done >= 1 - 1e-9;
        if (done - shown_ < (terminal_ ? terminal_step : plain_step) && !last) {
            return;
        }
        shown_ = done;
        auto const text = fmt::format("{:.0f} %{}", 100 * done, last ? "" : ", " + duration_text(left_s) + " left");
        print_note("{}{:<30}{}", terminal_ ? "\r" : "", text, terminal_ && !last ? "" : "\n");
        std::fflush(stderr);
    }

  private:
    bool terminal_ = isatty(STDERR_FILENO) != 0;
    double shown_ = 0;
};

void check(CostOptions const& options) {
    validate(options.waves.value_or(1) > 0, "--waves {} (no sample). Give 1 or more, or leave it out",
             options.waves.value_or(1));
    validate(!options.sensitivity || !options.output,
             "-o beside --sensitivity (its tables are no study in HDF5). Use --json, or --html");
    if (options.output) {
        validate(!options.output->empty(), "-o '' (no name: an unset variable?). Name a file");
        validate(!std::filesystem::exists(*options.output),
                 "-o {}: exists already (it would be lost). Choose another name, or remove it", *options.output);
        store::require_writable(*options.output);
    }
    if (!options.page.empty()) {
        require_page(options.page);
    }
}

// Prints a study as text or JSON. \return the JSON
output::Json printed(CostOptions const& options, CampaignInput const& input, std::vector<output::Table> const& tables,
                     std::string const& text) {
    auto json = output::json_of(tables);
    json["campaign_sha256"] = input.sha256();
    fmt::print("{}", options.json ? json.dump(2) + "\n" : text);
    return json;
}

void write_page(CostOptions const& options, std::string (*page_of)(output::Json const&), output::Json const& json) {
    if (!options.page.empty()) {
        store::write_durably(options.page, page_of(json));
        print_note("page: {}\n", options.page);
    }
}

int study(CostOptions const& options) {
    check(options);
    auto const input = load_campaign(options.campaign, options.settings);
    Remaining remaining;
    auto const progress = [&](double done, double left_s) { remaining(done, left_s); };
    if (options.sensitivity) {
        auto const found = cost::study_sensitivity(input, options.waves.value_or(0), progress);
        write_page(options, &report::sensitivity_page,
                   printed(options, input, cost::sensitivity_tables(found), cost::sensitivity_text(found)));
        return done;
    }
    auto const found = cost::run_study(input, {.waves = options.waves.value_or(0)}, progress);
    auto const json = printed(options, input, cost::study_tables(found), cost::study_text(found));
    if (options.output) {
        cost::write_study(*options.output, input, found);
        print_note("study: {}\n", *options.output);
    }
    write_page(options, &report::cost_page, json);
    return done;
}

}  // namespace

void add_cost(CommandLine& line) {
    auto verb = line.verb("cost", "error and computing time of each setting, on a campaign's waves");
    auto options = std::make_shared<CostOptions>();
    verb.needs("campaign", options->campaign, "campaign file (TOML)");
    verb.takes("-o,--output", options->output, "write the study as HDF5 (computing times differ from run to run)");
    verb.takes("--html", options->page, "write a page with figures and tables (no network needed)", "PAGE.html");
    verb.takes("--waves", options->waves, "waves of the sample; default: as many as take about one minute");
    verb.takes("--sensitivity", options->sensitivity,
               "instead: effect of each assumed value on median and P (at most 200 waves)");
    verb.takes("--set", options->settings, "override keys: waves.count=50 seed=2", "KEY=VALUE ...");
    verb.takes("--json", options->json, "as JSON");
    verb.does([options] { return study(*options); });
}

}  // namespace overturn::cli
