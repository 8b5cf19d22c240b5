#include <fmt/format.h>

#include "campaign/results.hpp"

namespace overturn {
namespace {

// "~" where undecided trials make it an estimate from part of the stripe, "-" where nothing is decided.
std::string probability_text(Stripe const& stripe) {
    if (stripe.decided() == 0) {
        return "-";
    }
    return fmt::format("{}{:.4f}", stripe.decided() < stripe.trials ? "~" : "", stripe.probability());
}

void append_body(std::string& text, CampaignSpec const& spec, BodySpec const& body, BodyStatistics const& s) {
    text += fmt::format("\n{}: alpha {:.1f} deg, R {:.3f} m, e {:.3f}, {}V_Ereq {:.3f} m/s\n", body.name,
                        body.body.alpha_rad() * 180 / pi, body.body.radius_m(), body.body.restitution(),
                        body.friction ? fmt::format("friction {:g}/{:g}, ", body.friction->static_coefficient,
                                                    body.friction->kinetic_coefficient)
                                      : std::string("no slip, "),
                        body.body.limit_velocity_mps());
    text += fmt::format("{:>10} {:>7} {:>8} {:>6} {:>11} {:>7} {:>7}  {:>8}  {:>20}  {:>16}\n",
                        fmt::format("{} {}", spec.levels.measure_name(), spec.levels.units()), "trials", "at rest",
                        "slid", "overturned", "lost", "failed", "P",
                        fmt::format("{:g} % interval", 100 * spec.confidence), "V_WES safe/wrong");
    std::int64_t sliding = 0;
    for (std::size_t l = 0; l < s.stripes.size(); ++l) {
        auto const& stripe = s.stripes[l];
        auto const interval = stripe.interval(spec.confidence);
        auto const purpose = spec.levels.levels[l].purpose;
        text +=
            fmt::format("{:>10.4g} {:>7} {:>8} {:>6} {:>11} {:>7} {:>7}  {:>8}  [{:.6f}, {:.6f}]  {:>9} / {:<5}{}\n",
                        stripe.amplitude, stripe.trials, stripe.at_rest, stripe.slid, stripe.overturned,
                        stripe.contact_lost, stripe.failed, probability_text(stripe), interval.lower, interval.upper,
                        s.v_wes[l].true_safe + s.v_wes[l].false_safe, s.v_wes[l].false_safe,
                        purpose == LevelClass::ordinary ? std::string() : fmt::format(" {}", name_of(purpose)));
        sliding += s.sliding_called[l];
    }
    text += "rungs:";
    for (std::size_t r = 0; r < s.rungs.size(); ++r) {
        text += fmt::format("{} {} {}", r == 0 ? "" : ",", s.rungs[r], rung_names()[r]);
    }
    text += "\n";
    if (sliding > s.rungs.back()) {
        text +=
            fmt::format("note: {} trials would have slipped (friction demand above {}), and slip was not simulated\n",
                        sliding, body.friction->static_coefficient);
    }
}

}  // namespace

std::string stripe_table(CampaignSpec const& spec, Statistics const& statistics) {
    std::string text = spec.title.empty() ? "" : spec.title + "\n";
    auto const waves = statistics.waves().text(spec.source->acceptance());
    text += waves.empty() ? "" : waves + "\n";
    for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
        append_body(text, spec, spec.bodies[b], statistics.bodies()[b]);
    }
    return text;
}

std::string rung_costs(PhaseSeconds const& seconds) {
    std::string text;
    for (std::size_t r = 0; r < seconds.rungs.size(); ++r) {
        auto const& rung = seconds.rungs[r];
        if (rung.trials > 0) {
            text += fmt::format("{}{} {} trials, {:.1f} us each", text.empty() ? "" : "; ", rung_names()[r],
                                rung.trials, 1e6 * rung.seconds / static_cast<double>(rung.trials));
        }
    }
    return text;
}

}  // namespace overturn
