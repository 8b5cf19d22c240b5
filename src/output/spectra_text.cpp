#include "output/spectra_text.hpp"

#include <cmath>
#include <cstddef>
#include <string>

#include <fmt/format.h>

#include "campaign/typed_units.hpp"
#include "core/texts_of.hpp"
#include "core/wrapped.hpp"

namespace overturn::output {
namespace {

std::string number(double value) { return std::isnan(value) ? std::string("-") : fmt::format("{:.4g}", value); }

std::string columns(std::string const& first, std::string const& second, std::string const& third) {
    return fmt::format(" {:>10} {:>10} {:>10}", first, second, third);
}

std::string columns(SpectrumBand const& band, std::size_t i, double si) {
    return columns(number((band.few ? band.lowest : band.p16)[i] / si), number(band.p50[i] / si),
                   number((band.few ? band.highest : band.p84)[i] / si));
}

std::string lines_above(CampaignSpec const& spec, SpectraOfWaves const& spectra) {
    auto const left_out =
        spectra.left_out > 0 ? fmt::format(" ({} more could not be generated)", spectra.left_out) : "";
    auto text = wrapped(fmt::format("{}{}, unscaled. Variability: {}", count_text(std::ssize(spectra.waves), "wave"),
                                    left_out, spec.source->about().variability));
    for (auto const& remark : spec.source->about().remarks) {
        text += wrapped("Remark: " + remark);
    }
    return text;
}

}  // namespace

std::string spectra_text(CampaignSpec const& spec, SpectraOfWaves const& spectra, ShownVelocity const& velocity) {
    constexpr std::size_t every = 5;
    auto const acceleration = typed_units(spec).acceleration;
    auto const& targets = spectra.targets;
    auto const percentiles =
        spectra.psa_mps2.few ? columns("lowest", "50 %", "highest") : columns("16 %", "50 %", "84 %");
    auto text = lines_above(spec, spectra);
    text += fmt::format("{:>9}{}{}{}\n", "", columns("pSa " + acceleration.symbol, "", ""),
                        targets ? columns("targets", "", "") : "", columns("V_E " + velocity.symbol, "", ""));
    text += fmt::format("{:>9}{}{}{}\n", "period s", percentiles, targets ? percentiles : "", percentiles);
    for (std::size_t i = 0; i < spectra.period_s.size(); i += every) {
        text += fmt::format("{:>9.4f}{}{}{}\n", spectra.period_s[i], columns(spectra.psa_mps2, i, acceleration.si),
                            targets ? columns(*targets, i, acceleration.si) : "",
                            columns(spectra.v_e_mps, i, velocity.si()));
    }
    return text
           + wrapped(fmt::format("Damping: {:g} % for pSa{}, {:g} % for V_E. --json has every wave at all {} periods.",
                                 100 * spectra.damping, targets ? " and targets" : "", 100 * spectra.energy_damping,
                                 spectra.period_s.size()));
}

}  // namespace overturn::output
