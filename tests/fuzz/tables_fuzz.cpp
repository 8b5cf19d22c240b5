// Requirement: whatever bytes a table of others holds - a target, a hazard curve, stripes, capacities, outcomes - it is
// read as finite numbers or refused with InputError; nothing else happens.
#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>

#include "campaign/campaign_spec.hpp"
#include "campaign/plan.hpp"
#include "cli/capacity_csv.hpp"
#include "cli/outcome_csv.hpp"
#include "cli/stripe_csv.hpp"
#include "core/error.hpp"
#include "results/hazard_table.hpp"
#include "spectra/detail/design_json.hpp"
#include "spectra/detail/design_part.hpp"
#include "spectra/target_spectrum.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size);

namespace {

using namespace overturn;

template <class Read> void refused_or(Read const& read) {
    try {
        read();
    } catch (InputError const&) {
        return;
    }
}

void expect_finite(double value) {
    if (!std::isfinite(value)) {
        std::abort();  // a number that is none must not come through
    }
}

void read_target(std::string const& text, TargetKind kind, std::optional<double> unit_si) {
    refused_or([&] {
        auto const chosen = is_json(text) ? std::nullopt : table_of_one_ordinate(text, "t", "Sa");
        auto const target = is_json(text)
                                ? target_of_table(table_of_design_json(text, "t", "", kind), "t", kind, 0.05, unit_si)
                                : parse_target_table(chosen ? *chosen : text, "t", kind, 0.05, unit_si);
        if (target.defined_at(1)) {
            expect_finite(target.psa_mps2(1));
        }
    });
}

CampaignSpec const& two_waves() {
    static auto const spec = parse_campaign({"c.toml",
                                             R"(seed = 1
waves = {source = "harmonic", amplitude = "1 m/s2", frequencies = [1], duration = "4 s", time_step = "0.02 s"}
bodies = [{name = "b", mass = "1 t", base_width = "1 m", centre_height = "2 m", inertia = "uniform-block"}]
levels = {measure = "factor", values = [1]})",
                                             {},
                                             {}});
    return spec;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
    std::string const text(reinterpret_cast<char const*>(data), size);
    read_target(text, TargetKind::acceleration, {});
    read_target(text, TargetKind::displacement, 0.01);
    static auto const& spec = two_waves();
    static auto const plan = Plan(spec);
    refused_or([&] {
        auto const hazard = parse_hazard(text, "h", spec.levels);
        expect_finite(hazard.annual_exceedance(hazard.first()));
        expect_finite(hazard.annual_exceedance(hazard.last()));
    });
    refused_or([&] {
        for (auto const& stripe : cli::parse_stripes(text, "s").stripes) {
            expect_finite(stripe.amplitude);
        }
    });
    refused_or([&] { (void)cli::parse_capacities(text, "c"); });
    refused_or([&] { (void)cli::parse_outcomes(text, "o", spec, plan); });
    return 0;
}
