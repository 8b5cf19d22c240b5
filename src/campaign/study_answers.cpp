#include "campaign/study_answers.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>

#include "core/error.hpp"
#include "core/parts_of.hpp"
#include "generators/acceptance.hpp"
#include "spectra/named_targets.hpp"

namespace overturn {
namespace {

// Of a bare number, which may be meant in more than one of them.
std::string with_usual_units(std::string const& number, Dimension dimension) {
    auto const* const larger = dimension == Dimension::mass ? "t" : dimension == Dimension::pressure ? "MPa" : "";
    auto const other = larger[0] == 0 ? std::string() : fmt::format("\"{} {}\" or ", number, larger);
    return fmt::format("{}\"{} {}\"", other, number, si_symbol(dimension));
}

template <Dimension dimension> void check_quantity(std::string const& text) {
    double number = 0;
    validate(!parse_number(text, number), "'{}' (a number without its unit). Write {}, or with your own unit", text,
             with_usual_units(text, dimension));
    validate(parse_quantity(text, dimension) > 0, "'{}' (not above 0). State a {}", text, name_of(dimension));
}

void check_number(std::string const& text, double least, double most, char const* range) {
    double number = 0;
    validate(parse_number(text, number) && number >= least && number <= most, "'{}' (must be a number {}). Give one",
             text, range);
}

void check_word(std::string const& text, std::vector<std::string> const& words) {
    validate(std::ranges::find(words, text) != words.end(), "'{}' (unknown). {}", text,
             config::suggestion(text, words));
}

constexpr double largest_friction = 1e3;

void check_friction(std::string const& text) {
    constexpr char const* range = "from 0, or a band such as 0.3 to 0.6";
    auto const band = band_in(text);
    if (!band) {
        check_number(text, 0, largest_friction, range);
        return;
    }
    check_number(band->first, 0, largest_friction, range);
    check_number(band->second, 0, largest_friction, range);
    double low = 0;
    double high = 0;
    validate(parse_number(band->first, low) && parse_number(band->second, high) && low < high,
             "'{}' (the second number must be above the first). Write for example 0.3 to 0.6", text);
}

bool is_quantity(std::string const& text, Dimension dimension) {
    try {
        double number = 0;
        return !parse_number(text, number) && parse_quantity(text, dimension) > 0;
    } catch (InputError const&) {
        return false;
    }
}

void check_level(std::string const& text) {
    if (text.find_first_of(" \t") == std::string::npos) {
        double number = 0;
        validate(!parse_number(text, number), "'{}' (a number without its unit). Write for example \"{} gal\"", text,
                 text);
        (void)parse_quantity(text, Dimension::acceleration);  // no quantity without a blank: says why
    }
    validate(is_quantity(text, Dimension::acceleration) || is_quantity(text, Dimension::velocity),
             "'{}' (must be a number above 0, a blank and a unit of acceleration or velocity). Write for example \"600 "
             "gal\", \"0.3 g\" or \"100 kine\"",
             text);
}

void check_levels(std::string const& text) {
    for (auto const& level : listed_in(text)) {
        validate(!level.empty(), "'{}' (nothing between two commas). Write for example 900 gal, 1200 gal", text);
        check_level(level);
    }
}

Dimension dimension_of_level(std::string const& level) {
    return is_quantity(level, Dimension::acceleration) ? Dimension::acceleration : Dimension::velocity;
}

void check_count(std::string const& text) {
    constexpr double most = 1e9;
    check_number(text, 1, most, "from 1 to 1000000000");
    validate(text.find_first_not_of("0123456789") == std::string::npos, "'{}' (must be a whole number). Give one",
             text);
}

void check_restitution(std::string const& text) {
    if (text != "housner") {
        check_number(text, 0, 1, "from 0 to 1, or housner");
    }
}

void check_pallet_friction(std::string const& text) {
    if (text != "fastened") {
        check_number(text, 0, largest_friction, "from 0, or fastened");
    }
}

void check_target(std::string const& text) {
    auto const published = config::names_of(named_targets());
    std::error_code error;
    validate(std::ranges::find(published, text) != published.end() || std::filesystem::exists(text, error),
             "'{}' (neither a published spectrum nor a file). {}", text, config::suggestion(text, published));
    validate(text != "rg-1.60-vertical", "'{}' (of the vertical component). State rg-1.60, which brings it along",
             text);
}

void check_file(std::string const& text) {
    validate(std::filesystem::exists(text), "'{}' (no such file). Check the name", text);
}

void take_as_it_is(std::string const& /*text*/) {}

bool of_pallet(StudyAnswers const& answers) { return answers.has_pallet(); }
bool of_one_block(StudyAnswers const& answers) { return !answers.has_pallet(); }
bool of_spectrum(StudyAnswers const& answers) { return answers.spectrum.has_value(); }
bool of_spectrum_file(StudyAnswers const& answers) { return answers.has_spectrum_file(); }
bool of_records(StudyAnswers const& answers) { return answers.records.has_value(); }
bool without_spectrum(StudyAnswers const& answers) { return !answers.spectrum; }
bool of_site(StudyAnswers const& answers) { return answers.has_site() && !answers.has_pallet(); }

constexpr double least_beta_u = std::numeric_limits<double>::min(), largest_beta_u = 5;

constexpr char const* without_pallet = "used only with --pallet-mass";

using Answers = StudyAnswers;
constexpr std::array questions{
    StudyQuestion{"--mass", "'117 t'", "mass of the cask; without --pallet-mass that of the cask and what is under it",
                  &Answers::mass, check_quantity<Dimension::mass>, true},
    StudyQuestion{"--pallet-mass", "'21 t'",
                  "mass of the pallet or foot under the cask; without it --mass is one block of uniform density",
                  &Answers::pallet_mass, check_quantity<Dimension::mass>},
    StudyQuestion{"--pallet-height", "'0.35 m'", "height of the pallet", &Answers::pallet_height,
                  check_quantity<Dimension::length>, true, of_pallet, without_pallet},
    StudyQuestion{"--cask-diameter", "'2.5 m'", "diameter of the cask on the pallet", &Answers::cask_diameter,
                  check_quantity<Dimension::length>, true, of_pallet, without_pallet},
    StudyQuestion{"--cask-height", "'5.4 m'", "height of the cask alone", &Answers::cask_height,
                  check_quantity<Dimension::length>, true, of_pallet, without_pallet},
    StudyQuestion{"--pallet-friction", "0.3|fastened",
                  "coefficient of friction between cask and pallet, or fastened; without it unknown",
                  &Answers::pallet_friction, check_pallet_friction, false, of_pallet, without_pallet},
    StudyQuestion{"--centre-height", "'2.6 m'", "height of the centre of gravity above the ground",
                  &Answers::centre_height, check_quantity<Dimension::length>, true, of_one_block,
                  "it follows from cask and pallet, which are given; or give the --mass of both, and no --pallet-mass"},
    StudyQuestion{"--base-width", "'3.4 m'", "width or diameter of the base: of the cask, its feet or the pallet",
                  &Answers::base_width, check_quantity<Dimension::length>, true},
    StudyQuestion{"--base-shape", "square|round", "outline of the base; without it square, on its corners",
                  &Answers::base_shape,
                  [](std::string const& text) {
                      check_word(text, {"square", "round"});
                  }},
    StudyQuestion{"--friction", "0.5|'0.3 to 0.6'",
                  "coefficient of friction between base and pad, or a band, drawn evenly for each wave; without it two "
                  "bodies: 0.2 and 0.8",
                  &Answers::friction, check_friction},
    StudyQuestion{"--restitution", "0.9|housner", "ratio of angular velocities after and before an impact",
                  &Answers::restitution, check_restitution},
    StudyQuestion{"--pad-strength", "'30 MPa'", "compressive strength of the pad", &Answers::pad_strength,
                  check_quantity<Dimension::pressure>},
    StudyQuestion{"--gap", "'0.8 m'", "distance to the next cask, in all directions", &Answers::gap,
                  check_quantity<Dimension::length>},
    StudyQuestion{"--wall", "'1.5 m'", "distance to a wall, in all directions", &Answers::wall,
                  check_quantity<Dimension::length>},
    StudyQuestion{"--edge", "'2 m'", "distance to the edge of the pad, in all directions", &Answers::edge,
                  check_quantity<Dimension::length>},
    StudyQuestion{"--height", "'5.2 m'", "full height of the cask above the ground", &Answers::height,
                  check_quantity<Dimension::length>, false, of_site,
                  "used only with --gap, --wall or --edge, and without --pallet-mass"},
    StudyQuestion{"--spectrum", "NAME|FILE", "target spectrum: a published one (overturn list targets) or a file",
                  &Answers::spectrum, check_target},
    StudyQuestion{"--spectrum-kind", "KIND",
                  "quantity in the spectrum file: acceleration, pseudo-velocity, displacement or energy-velocity",
                  &Answers::spectrum_kind,
                  [](std::string const& text) { check_word(text, config::names_of(target_kinds())); }, true,
                  of_spectrum_file, "used only if --spectrum names a file"},
    StudyQuestion{"--spectrum-unit", "gal", "unit of the spectrum file's ordinates, if it does not state it",
                  &Answers::spectrum_unit, take_as_it_is, false, of_spectrum_file,
                  "used only if --spectrum names a file"},
    StudyQuestion{
        "--components", "1|2|3", "components of the motion: 1 (one horizontal), 2 (both horizontal), 3 (and vertical)",
        &Answers::components,
        [](std::string const& text) {
            validate(text == "1" || text == "2" || text == "3", "'{}' (no such number). Choose 1, 2 or 3", text);
        },
        false, of_spectrum, "used only with --spectrum"},
    StudyQuestion{"--duration", "'120 s'", "duration of every wave", &Answers::duration,
                  check_quantity<Dimension::time>, false, of_spectrum, "used only with --spectrum"},
    StudyQuestion{"--acceptance", "none|srp-3.7.1|japan",
                  "rule that every wave must meet (a wave that misses it is drawn again)", &Answers::acceptance,
                  [](std::string const& text) { check_word(text, config::names_of(acceptance_rules())); }, false,
                  of_spectrum, "used only with --spectrum"},
    StudyQuestion{"--records", "FILE|FOLDER", "recorded motions: a file or a folder", &Answers::records, check_file,
                  true, without_spectrum, "--spectrum is given: waves come from one of the two"},
    StudyQuestion{"--record-unit", "gal", "unit of the records, if the files do not state it", &Answers::record_unit,
                  take_as_it_is, false, of_records, "used only with --records"},
    StudyQuestion{"--baseline", "'high-pass 0.05 Hz'", "baseline correction: none, mean, polynomial or a high-pass",
                  &Answers::baseline, take_as_it_is, false, of_records, "used only with --records"},
    StudyQuestion{"--count", "100", "number of waves", &Answers::count, check_count},
    StudyQuestion{"--design-basis", "'0.3 g'", "peak acceleration or velocity of the design basis",
                  &Answers::design_basis, check_level, true},
    StudyQuestion{"--beyond-design", "'900 gal, 1200 gal'",
                  "levels beyond the design basis; without it 1.5 and 2 times the design basis",
                  &Answers::beyond_design, check_levels},
    StudyQuestion{"--levels", "'300 gal, 600 gal'",
                  "further levels, for the curves; without it from 0.5 to 5 times the design basis", &Answers::levels,
                  check_levels},
    StudyQuestion{"--hazard", "CURVE.csv", "seismic hazard curve, for annual frequencies", &Answers::hazard,
                  check_file},
    StudyQuestion{"--beta-u", "0.3",
                  "beta_U for HCLPF: lognormal standard deviation of the median from uncertain properties of the cask",
                  &Answers::beta_u, [](std::string const& text) {
                      check_number(text, least_beta_u, largest_beta_u, "above 0, at most 5");
                  }}};

// All levels are of one measure.
void check_levels_beside_design_basis(StudyAnswers const& answers) {
    for (auto const& question : questions) {
        bool const levels = question.answer == &Answers::beyond_design || question.answer == &Answers::levels;
        if (!levels || !answers.design_basis) {
            continue;
        }
        for (auto const& level : listed_in((answers.*question.answer).value_or(*answers.design_basis))) {
            auto const dimension = answers.level_dimension();
            validate(dimension_of_level(level) == dimension,
                     "{} '{}' (--design-basis '{}' is another measure: {}). State all levels in one", question.option,
                     level, *answers.design_basis, name_of(dimension));
        }
    }
}

}  // namespace

bool StudyAnswers::has_spectrum_file() const {
    auto const published = config::names_of(named_targets());
    return spectrum && std::ranges::find(published, *spectrum) == published.end();
}

Dimension StudyAnswers::level_dimension() const { return dimension_of_level(design_basis.value_or("")); }

std::vector<std::string> listed_in(std::string const& answer) {
    std::vector<std::string> parts;
    for (auto const part : parts_of(answer, ',')) {
        parts.emplace_back(trimmed(part));
    }
    return parts;
}

std::optional<std::pair<std::string, std::string>> band_in(std::string const& answer) {
    constexpr std::string_view between = " to ";
    auto const at = answer.find(between);
    return at == std::string::npos
               ? std::nullopt
               : std::optional(std::pair(std::string(trimmed(std::string_view(answer).substr(0, at))),
                                         std::string(trimmed(std::string_view(answer).substr(at + between.size())))));
}

std::span<StudyQuestion const> study_questions() { return questions; }

void check_answer(StudyQuestion const& question, std::string const& answer) {
    try {
        validate(!trimmed(answer).empty(), "'' (empty: an unset variable?). Give a value, or leave the option out");
        auto const control = [](unsigned char c) { return c < ' ' || c == 0x7F; };
        validate(std::ranges::none_of(answer, control), "(holds a control character). Write it on one line");
        question.check(answer);
    } catch (InputError const& error) {
        throw InputError(fmt::format("{} {}", question.option, error.what()));
    }
}

void check_answers(StudyAnswers const& answers) {
    for (auto const& question : questions) {
        if (auto const& answer = answers.*question.answer) {
            check_answer(question, *answer);
            validate(question.applies(answers), "{} '{}' ({}). Leave it out", question.option, *answer,
                     question.otherwise);
        }
    }
    if (answers.height && answers.centre_height) {
        validate(parse_quantity(*answers.height, Dimension::length)
                     > parse_quantity(*answers.centre_height, Dimension::length),
                 "--height '{}' (not above the centre of gravity, {}). State the full height", *answers.height,
                 *answers.centre_height);
    }
    if (answers.spectrum && answers.design_basis && is_scaled_by_pga(*answers.spectrum)) {
        validate(answers.level_dimension() == Dimension::acceleration,
                 "--design-basis '{}' (a velocity; {} is scaled by a peak acceleration). Give one such as '0.3 g'; a "
                 "campaign file may state it as waves.target.pga = \"0.3 g\" beside levels of velocity",
                 *answers.design_basis, *answers.spectrum);
    }
    check_levels_beside_design_basis(answers);
}

std::vector<std::string> missing_answers(StudyAnswers const& answers) {
    std::vector<std::string> missing;
    for (auto const& question : questions) {
        if (question.must && question.applies(answers) && !(answers.*question.answer)) {
            bool const has_another = question.answer == &StudyAnswers::records;
            missing.emplace_back(has_another ? "--spectrum or --records" : question.option);
        }
    }
    return missing;
}

}  // namespace overturn
