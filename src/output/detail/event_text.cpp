#include "output/detail/event_text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "campaign/typed_units.hpp"
#include "core/text_width.hpp"
#include "output/detail/interval_text.hpp"
#include "output/package_text.hpp"
#include "response/registry.hpp"

namespace overturn::output {

std::string rare_text(CampaignSpec const& spec, std::span<RareBody const> bodies) {
    std::string text;
    for (auto const& body : bodies) {
        auto const& limit = spec.limits[body.limit];
        text += fmt::format("\nrare events of {}{}, by {}\n{:>10}  {:>10}  {:>22}  {:>6}  {:>13}  {:>9}  {:>10}\n",
                            spec.bodies[body.body].name, body.limit == 0 ? "" : ": " + full_name(limit, spec.limits),
                            spec.levels.measure_name(), "factor", "P", "95 % interval", "c.o.v.", "method", "waves",
                            "crude");
        for (auto const& e : body.estimates) {
            auto const interval = interval_text(e.interval_95);
            text += e.probability
                        ? fmt::format("{:>10.4g}  {:>10.3e}  {:>22}  {:>6.3f}  {:>13}  {:>9}  {:>10.2g}\n", e.factor,
                                      *e.probability, interval, e.cov, name_of(e.method), e.runs, e.crude_runs)
                        : fmt::format("{:>10.4g}  {:>10}  {:>22}  {:>6}  {:>13}  {:>9}  {}: {}\n", e.factor,
                                      fmt::format("< {:.2e}", rounded_up(e.interval_95.upper)), "", "",
                                      name_of(e.method), e.runs, name_of(e.state), e.reason);
        }
        for (auto const& e : body.estimates) {
            for (auto const& words : e.tried) {
                text += fmt::format("  note: at factor {:.4g} tried before: {}\n", e.factor, words);
            }
            if (e.probability && e.cov > spec.rare->target_cov) {
                text += fmt::format(
                    "  note: at factor {:.4g} the c.o.v. {:.3f} exceeds target_cov {:g} (replicates grow up to "
                    "four times, within max_runs). State more of them\n",
                    e.factor, e.cov, spec.rare->target_cov);
            }
        }
    }
    return text;
}

std::string hand_check_text(CampaignSpec const& spec, std::span<HandCheck const> checks) {
    auto const lines = hand_check_lines(spec, checks);
    return lines.empty() ? std::string()
                         : fmt::format("\nhand calculation: {}\n  {}\n", lines.front(),
                                       fmt::join(std::span(lines).subspan(1), "\n  "));
}

std::string telling_text(CampaignSpec const& spec, std::span<TellingTrial const> trials, std::string const& file) {
    if (trials.empty()) {
        return {};
    }
    constexpr std::size_t heading = 4;
    std::size_t wide = heading;
    for (auto const& body : spec.bodies) {
        wide = std::max(wide, text_width(body.name));
    }
    auto const slip = typed_units(spec).slip;
    auto const row = [&](auto const&... cells) {
        return fmt::format("{:<{}}  {:<16} {:>7} {:>6} {:>9}  {:<15} {:>10} {:>8} {:>9}\n", cells...);
    };
    auto text = fmt::format("trials to inspect (overturn replay {} --trial N)\n", file)
                + row("body", wide, "kind", "trial", "wave", spec.levels.measure_name(), "verdict", "peak/alpha",
                      "slip " + slip.symbol, "fell at");
    for (auto const& t : trials) {
        text += row(spec.bodies[t.body].name, wide, telling_kinds.at(static_cast<std::size_t>(t.kind)), t.trial, t.wave,
                    spec.levels.text(t.amplitude), entry_of(t.verdict).name,
                    fmt::format("{:.4g}", t.peak_rotation_ratio), fmt::format("{:.4g}", slip.of(t.peak_slip_m)),
                    std::isnan(t.overturned_at) ? std::string("-") : spec.levels.text(t.overturned_at));
    }
    return text;
}

}  // namespace overturn::output
