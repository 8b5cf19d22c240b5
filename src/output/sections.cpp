#include "output/sections.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "core/parts_of.hpp"
#include "core/wrapped.hpp"
#include "output/curve_text.hpp"
#include "output/detail/criterion_text.hpp"
#include "output/detail/event_text.hpp"
#include "output/detail/fit_words.hpp"
#include "output/detail/limit_text.hpp"
#include "output/detail/together_text.hpp"
#include "output/frequency_text.hpp"
#include "output/records_table.hpp"
#include "output/stripe_text.hpp"
#include "output/waves_text.hpp"

namespace overturn::output {
namespace {

// Each sentence once, behind the names of all curves that it is about.
std::vector<std::string> notes_of(Answered const& of) {
    std::vector<std::pair<std::string, std::string>> about;  // sentence, names
    for (auto const& body : of.analysis) {
        for (std::size_t limit = 0; limit < of.spec.limits.size() && !body.grid; ++limit) {
            auto const& curve = body.curves_of(limit).front();
            auto const name = limit == 0
                                  ? body.body
                                  : fmt::format("{} ({})", body.body, full_name(of.spec.limits[limit], of.spec.limits));
            for (auto const& sentence : warnings_of(curve.fit, curve.shown_in, of.confidence)) {
                auto const known = std::ranges::find(about, sentence, &std::pair<std::string, std::string>::first);
                if (known == about.end()) {
                    about.emplace_back(sentence, name);
                } else {
                    known->second += ", " + name;
                }
            }
        }
    }
    std::vector<std::string> notes;
    notes.reserve(about.size());
    for (auto const& [sentence, names] : about) {
        notes.push_back(fmt::format("{}: {}", names, sentence));
    }
    return notes;
}

std::string notes_text(Printed const& printed, bool all) {
    constexpr std::size_t most = 5;
    bool const no_curves = !no_probability_text(printed.answered).empty();
    auto const notes = no_curves ? std::vector<std::string>() : notes_of(printed.answered);
    std::string text;
    for (std::size_t n = 0; n < notes.size() && (all || n < most); ++n) {
        text += wrapped("note: " + notes[n], 6);
    }
    if (!all && notes.size() > most) {
        text += fmt::format("note: {} more, in --section curves\n", notes.size() - most);
    }
    return text + missed_clauses_text(printed.answered.statistics.missed_clauses()) + printed.notes;
}

std::string responses_text(Answered const& of) {
    std::string text;
    for (auto const& body : of.analysis) {
        auto const quantiles = quantiles_text(of.spec, body, of.confidence);
        text += quantiles.empty() ? std::string() : fmt::format("\n{}\n{}", body.body, quantiles);
    }
    return text;
}

bool always(Printed const& /*printed*/) { return true; }
bool never_unasked(Printed const& /*printed*/) { return false; }
bool is_grid(Printed const& printed) { return printed.answered.spec.is_grid(); }
bool is_enough(Printed const& printed) { return no_probability_text(printed.answered).empty(); }

std::string together(Printed const& printed, TextOptions const& /*options*/) {
    auto const& of = printed.answered;
    return together_text(of.spec, bodies_together(of.spec, of.statistics), of.confidence)
           + (printed.pairs.empty() ? std::string() : two_measures_text(of.spec, printed.pairs, of.confidence));
}

struct Section {
    std::string_view name;
    bool (*is_there)(Printed const&);    // is there anything of it in this campaign?
    bool (*is_unasked)(Printed const&);  // is it printed without being asked for? Where it is there
    std::string (*text)(Printed const&, TextOptions const&);
    std::string_view missing = "nothing in this campaign";
};

// In the order in which they are printed.
constexpr std::array sections{
    Section{"records", [](Printed const& p) { return !p.few.empty(); }, always,
            [](Printed const& p, TextOptions const&) { return records_text(p.answered.spec, p.few); }},
    Section{"stripes", always, is_grid,
            [](Printed const& p, TextOptions const& options) {
                return stripes_text(p.answered.spec, p.answered.statistics, options.velocities);
            }},
    Section{
        "curves", is_enough, is_grid,
        [](Printed const& p, TextOptions const&) { return curves_text(p.answered.analysis, p.answered.confidence); }},
    Section{"responses", is_enough, never_unasked,
            [](Printed const& p, TextOptions const&) { return responses_text(p.answered); }},
    Section{
        "criterion", [](Printed const& p) { return p.answered.spec.measures.energy; }, never_unasked,
        [](Printed const& p, TextOptions const&) { return criteria_text(p.answered.analysis, p.answered.confidence); }},
    Section{"together",
            [](Printed const& p) {
                return (p.answered.spec.bodies.size() > 1 && !is_grid(p) && is_enough(p)) || !p.pairs.empty();
            },
            [](Printed const& p) { return !p.pairs.empty(); }, together,
            "it needs several bodies (and no grid), or two measures: state them with --measures pga,pgv"},
    Section{"hand", always, never_unasked,
            [](Printed const& p, TextOptions const&) { return hand_check_text(p.answered.spec, p.by_hand); }},
    Section{"frequency", [](Printed const& p) { return p.hazard != nullptr && is_enough(p); }, always,
            [](Printed const& p, TextOptions const&) {
                return frequency_text(p.answered.frequencies, *p.hazard, p.answered.confidence);
            },
            "no hazard curve: state one with --hazard CURVE.csv, or in the campaign"},
    Section{"rare", [](Printed const& p) { return !p.answered.rare.empty(); }, always,
            [](Printed const& p, TextOptions const&) { return rare_text(p.answered.spec, p.answered.rare); },
            "no estimate of rare events: the campaign has no [rare]"},
    Section{"trials", always, never_unasked,
            [](Printed const& p, TextOptions const&) { return telling_text(p.answered.spec, p.telling, p.file); }}};

}  // namespace

bool TextOptions::names(std::string_view section) const {
    return std::ranges::find(sections, section) != sections.end();
}

std::vector<std::string_view> section_names() {
    std::vector<std::string_view> names;
    std::ranges::transform(sections, std::back_inserter(names), &Section::name);
    return names;
}

std::vector<std::string> read_sections(std::string const& text) {
    std::vector<std::string> names;
    if (text.empty()) {
        return names;
    }
    auto const known = section_names();
    for (auto const part : parts_of(text, ',')) {
        validate(part.find(' ') == std::string_view::npos,
                 "--section '{}' (a blank in it). Write for example "
                 "--section stripes,curves",
                 text);
        validate(std::ranges::find(known, part) != known.end(),
                 "--section '{}' (no such section). There are {} (those of a file: last line of overturn fit FILE)",
                 part, fmt::join(known, ", "));
        names.emplace_back(part);
    }
    return names;
}

std::string results_text(Printed const& printed, TextOptions const& options) {
    auto text = answer_text(printed.answered) + notes_text(printed, options.full);
    std::vector<std::string_view> there;
    for (auto const& section : sections) {
        bool const is_there = section.is_there(printed);
        if (is_there) {
            there.push_back(section.name);
        }
        if (is_there && (options.wants(section.name) || section.is_unasked(printed))) {
            auto const part = section.text(printed, options);
            text += part.empty() ? std::string() : fmt::format("\n== {}\n{}", section.name, narrowed(part));
        } else if (!is_there && options.names(section.name)) {
            auto const why = no_probability_text(printed.answered);
            text += fmt::format("\n== {}\n{}\n", section.name, why.empty() ? section.missing : why);
        }
    }
    if (!options.full && options.sections.empty()) {
        text += wrapped(fmt::format("more: overturn fit {} --full, or --section with some of {}", printed.file,
                                    fmt::join(there, ", ")));
    }
    return text;
}

}  // namespace overturn::output
