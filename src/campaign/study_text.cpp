#include "campaign/study_text.hpp"

#include <filesystem>
#include <vector>

#include <fmt/format.h>

#include "spectra/named_targets.hpp"

namespace overturn {
namespace {

std::string quoted(std::string const& text) {
    std::string out = "\"";
    for (char const c : text) {
        out += (c == '"' || c == '\\') ? std::string{'\\', c} : std::string(1, c);
    }
    return out + '"';
}

// As a POSIX shell takes it.
std::string as_argument(std::string const& text) {
    constexpr char const* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._/-";
    if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) {
        return text;
    }
    std::string out = "'";
    for (char const c : text) {
        out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return out + "'";
}

// A number that was typed, as TOML takes it: ".5" is 0.5 there, "housner" a text.
std::string as_value(std::string const& answer) {
    double number = 0;
    return parse_number(answer, number) ? fmt::format("{}", number) : quoted(answer);
}

// A band is drawn from evenly.
std::string as_friction(std::string const& answer) {
    auto const band = band_in(answer);
    return band ? fmt::format("{{distribution = \"uniform\", low = {}, high = {}}}", as_value(band->first),
                              as_value(band->second))
                : as_value(answer);
}

std::string as_list(std::vector<std::string> const& texts) {
    std::string list;
    for (auto const& text : texts) {
        list += (list.empty() ? "" : ", ") + quoted(text);
    }
    return "[" + list + "]";
}

// "0.3 g" by 1.5: "0.45 g".
std::string multiple(std::string const& level, double factor) {
    auto const blank = level.find_first_of(" \t");
    double number = 0;
    (void)parse_number(level.substr(0, blank), number);
    return fmt::format("{:.12g} {}", factor * number, trimmed(level.substr(blank)));
}

class StudyText {
  public:
    void line(std::string const& text) { text_ += text + '\n'; }
    void begin(std::string const& table) { text_ += fmt::format("\n{}\n", table); }
    void state(char const* key, std::string const& value) { text_ += fmt::format("{} = {}\n", key, value); }
    /// How much is run, which is no assumption about the world.
    void choose(char const* key, std::string const& value, std::string const& what) {
        text_ += fmt::format("# chosen: {}\n{} = {}\n", what, key, value);
    }
    /// \param what "120 s, because ...": the text behind "because" is stated as the source
    void assume(char const* key, std::string const& value, std::string const& what) {
        text_ += fmt::format("# assumed: {}\n{} = {}\n", what, key, value);
        note_basis(key, what);
    }
    /// A key that is not there, which is an assumption as well. \param example how its value would be stated
    void leave_out(char const* key, std::string const& example, std::string const& what) {
        text_ += fmt::format("# assumed: {}\n# {} = {}\n", what, key, example);
        note_basis(key, what);
    }
    /// A table that is not there. \param example of a key in it
    void leave_out_table(char const* table, std::string const& example, std::string const& what) {
        text_ += fmt::format("# assumed: {}\n# [{}]\n# {}\n", what, table, example);
        note_basis(table, what);
    }
    /// An answer as it was typed, or what is assumed without one.
    void state_or_assume(char const* key, std::optional<std::string> const& answer, std::string const& otherwise,
                         std::string const& what) {
        answer ? state(key, quoted(*answer)) : assume(key, otherwise, what);
    }
    /// Says which keys of the table were assumed.
    void end() {
        if (!assumed_.empty()) {
            text_ += fmt::format("basis = {{{}}}\n", assumed_);
        }
        assumed_.clear();
    }
    [[nodiscard]] std::string const& text() const { return text_; }

  private:
    void note_basis(char const* key, std::string const& what) {
        constexpr std::string_view because = ", because ";
        auto const reason = what.substr(what.find(because) + because.size());
        assumed_ += fmt::format("{}{} = {}", assumed_.empty() ? "" : ", ", key, quoted("assumed: " + reason));
    }

    std::string text_, assumed_;
};

// What is asked beside overturning, by what stands or ends near the cask.
std::string asked_beside(StudyAnswers const& a) {
    bool const touches = a.gap || a.wall;
    return touches && a.edge ? ", to touch or to leave its pad"
           : touches         ? " or to touch"
           : a.edge          ? " or to leave its pad"
                             : "";
}

void write_head(StudyText& out, std::string const& name, StudyAnswers const& a) {
    auto const results = std::filesystem::path(name).replace_extension(".h5").string();
    auto const page = std::filesystem::path(name).replace_extension(".html").string();
    auto const under = a.has_pallet() ? fmt::format("a pallet of {} and {}", *a.pallet_mass, *a.base_width)
                                      : fmt::format("a base of {}", *a.base_width);
    out.line("# Written by: " + study_command(name, a));
    out.line(
        "# Values that were not given are marked \"assumed\". Where you replace one, remove it from `basis` below "
        "too.");
    out.line(fmt::format("# Check it: overturn plan {}", as_argument(name)));
    out.line(fmt::format("# Run it: overturn run {}", as_argument(name)));
    out.line(fmt::format("# Read it: overturn fit {}; overturn report {} -o {}", as_argument(results),
                         as_argument(results), as_argument(page)));
    out.line("");
    out.state("title", quoted(fmt::format("Cask of {}, design basis {}", *a.mass, *a.design_basis)));
    out.state("question", quoted(fmt::format("How likely is a cask of {} on {} to overturn{} at {} and beyond?",
                                             *a.mass, under, asked_beside(a), *a.design_basis)));
    out.line("# For the cover of the page; take the # away from what you fill in.");
    for (auto const* key : {"prepared", "checked", "approved"}) {
        out.line(fmt::format("# {} = \"name\"", key));
    }
    out.line("# revision = \"0\"");
    out.state("seed", "1");
    a.hazard ? out.state("hazard", quoted(*a.hazard))
             : out.leave_out("hazard", "\"curve.csv\"", "no annual frequencies, because no hazard curve was given");
    if (!a.has_site()) {
        out.leave_out_table("site", "cask = \"0.8 m\"",
                            "no obstacle near the cask, because --gap, --wall and --edge were not given");
    }
    out.end();
}

void write_target(StudyText& out, StudyAnswers const& a) {
    out.begin("[waves.target]");
    if (a.has_spectrum_file()) {
        out.state("file", quoted(*a.spectrum));
        out.state("kind", quoted(*a.spectrum_kind));
        if (a.spectrum_unit) {
            out.state("unit", quoted(*a.spectrum_unit));
        }
    } else {
        out.state("spectrum", quoted(*a.spectrum));
        if (is_scaled_by_pga(*a.spectrum)) {
            out.state("pga", quoted(*a.design_basis));
        }
    }
    out.assume("damping", "0.05", "5 % damping, because it is usual for design spectra");
    out.end();
}

void write_further_components(StudyText& out, StudyAnswers const& a) {
    auto const write = [&](char const* table, bool has_own_target, char const* ratio, char const* what) {
        if (has_own_target) {
            out.begin(fmt::format("[waves.{}.target]", table));
            auto const vertical = quoted("rg-1.60-vertical");
            a.components ? out.state("spectrum", vertical)
                         : out.assume("spectrum", vertical,
                                      "the vertical spectrum of RG 1.60, because --components was not given");
            out.end();
            return;
        }
        out.begin(fmt::format("[waves.{}]", table));
        out.assume("ratio", ratio, what);
        out.end();
    };
    auto const components = a.components.value_or("3");
    if (components != "1") {
        write("transverse", false, "1",
              a.components
                  ? "as strong as the other horizontal component, because no second spectrum was given"
                  : "a second horizontal component as strong as the first, because --components was not given");
    }
    if (components == "3") {
        write("vertical", is_scaled_by_pga(*a.spectrum), "0.667",
              a.components
                  ? "two thirds of the horizontal spectrum, because no vertical spectrum was given"
                  : "a vertical component of two thirds of the horizontal one, because --components was not given");
    }
}

void write_drawn_waves(StudyText& out, StudyAnswers const& a) {
    bool const short_motion = is_scaled_by_pga(*a.spectrum);
    out.state("source", "\"spectrum-compatible\"");
    a.count ? out.state("count", as_value(*a.count))
            : out.choose("count", "100", "100 waves, because P < 0.037 (95 %) if none overturns");
    out.state_or_assume("duration", a.duration, short_motion ? "\"30 s\"" : "\"120 s\"",
                        short_motion ? "30 s, because no duration was given; at least 20 s are usual"
                                     : "120 s, because no duration was given and long-period motion lasts minutes");
    a.acceptance ? out.state("acceptance", quoted(*a.acceptance))
                 : out.leave_out("acceptance", "\"srp-3.7.1\"", "no acceptance rule for waves, because none was given");
    out.leave_out("envelope", R"({shape = "jennings", rise = "10 s", level_end = "60 s", end = "110 s"})",
                  "constant amplitude from 1/10 to 1/2 of the duration, because no envelope was given");
    out.leave_out("variability", "{sigma = 0.5, correlation = \"baker-jayaram-2008\"}",
                  "every wave follows the target spectrum, because no variability was given: curves are steeper than "
                  "those of recorded motions");
    out.end();
    write_target(out, a);
    write_further_components(out, a);
}

void write_records(StudyText& out, StudyAnswers const& a) {
    out.state("source", "\"records\"");
    if (!a.record_files.empty()) {
        out.state("folder", quoted(*a.records));
    }
    out.state("files", as_list(a.record_files.empty() ? std::vector{*a.records} : a.record_files));
    a.record_unit ? out.state("unit", quoted(*a.record_unit))
                  : out.leave_out("unit", "\"gal\"", "the unit that each file states, because no unit was given");
    a.baseline ? out.state("baseline", quoted(*a.baseline))
               : out.leave_out("baseline", "\"high-pass 0.05 Hz\"", "no baseline correction, because none was given");
    a.count ? out.state("count", as_value(*a.count))
            : out.line("# chosen: all records, because no number was given\n# count = 10");
    a.records_of_stations
        ? out.state("components", quoted("station") + "  # each with the other components of its station and event")
        : out.leave_out("components", "\"station\"", "the components of each file, because no others were given");
    out.end();
}

void write_cask_and_pallet(StudyText& out, StudyAnswers const& a) {
    out.begin("[[bodies.parts]]  # the cask, of uniform density");
    out.state("kind", quoted("cylinder"));
    out.state("mass", quoted(*a.mass));
    out.state("diameter", quoted(*a.cask_diameter));
    out.state("height", quoted(*a.cask_height));
    out.state("bottom", quoted(*a.pallet_height));
    if (a.pallet_friction == "fastened") {
        out.state("fastened", "true");
    } else if (a.pallet_friction) {
        out.state("friction", as_value(*a.pallet_friction));
    } else {
        out.leave_out("friction", "0.3", "cask and pallet move as one body, because --pallet-friction was not given");
    }
    out.end();
    bool const round = a.base_shape == "round";
    out.begin("[[bodies.parts]]  # the pallet, of uniform density");
    out.state("kind", quoted(round ? "cylinder" : "box"));
    out.state("mass", quoted(*a.pallet_mass));
    out.state(round ? "diameter" : "width", quoted(*a.base_width));
    out.state("height", quoted(*a.pallet_height));
    out.end();
}

void write_body(StudyText& out, StudyAnswers const& a, char const* name, char const* assumed_friction) {
    out.begin("[[bodies]]");
    out.state("name", quoted(name));
    if (!a.has_pallet()) {
        out.state("mass", quoted(*a.mass));
        out.state("centre_height", quoted(*a.centre_height));
    }
    out.state("base_width", quoted(*a.base_width));
    if (!a.has_pallet()) {
        out.assume("inertia", "\"uniform-block\"",
                   "all of this mass is one rigid body of uniform density, because neither inertia nor parts were "
                   "given: a cask on a pallet is taken as fastened to it");
    }
    a.friction ? out.state("friction", as_friction(*a.friction))
               : out.assume("friction", assumed_friction,
                            "two bodies with friction 0.2 and 0.8, because none was given: steel on concrete lies "
                            "between (NUREG/CR-6865, quoted from other papers)");
    if (a.restitution) {
        out.state("restitution", as_value(*a.restitution));
    } else if (a.base_shape == "round") {
        out.line("# restitution: that of rim and pad; a round base reads none unless it is stated");
    } else {
        out.assume("restitution", "\"housner\"", "restitution of a rigid block (Housner 1963), because none was given");
    }
    a.base_shape
        ? out.state("base", fmt::format("{{shape = {}}}", quoted(*a.base_shape)))
        : out.leave_out("base", "{shape = \"round\"}", "a square base on rigid corners, because no shape was given");
    a.pad_strength
        ? out.state("pad", fmt::format("{{strength = {}}}", quoted(*a.pad_strength)))
        : out.leave_out("pad", "{strength = \"30 MPa\"}", "a pad that is not crushed, because no strength was given");
    out.end();
    if (a.has_pallet()) {
        write_cask_and_pallet(out, a);
    }
}

void write_levels(StudyText& out, StudyAnswers const& a) {
    auto const multiples = [&](std::vector<double> const& factors) {
        std::vector<std::string> levels;
        levels.reserve(factors.size());
        for (double const factor : factors) {
            levels.push_back(multiple(*a.design_basis, factor));
        }
        return as_list(levels);
    };
    out.begin("[levels]");
    out.state("measure", a.level_dimension() == Dimension::acceleration ? "\"pga\"" : "\"pgv\"");
    out.state("design_basis", quoted(*a.design_basis));
    a.beyond_design ? out.state("beyond_design", as_list(listed_in(*a.beyond_design)))
                    : out.assume("beyond_design", multiples({1.5, 2}),
                                 "1.5 and 2 times the design basis, because no other beyond-design motion was given");
    a.levels ? out.state("values", as_list(listed_in(*a.levels)))
             : out.assume("values", multiples({0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0}),
                          "levels from 0.5 to 5 times the design basis, because a fragility curve needs levels where "
                          "some trials overturn");
    out.end();
}

void write_site(StudyText& out, StudyAnswers const& a) {
    if (!a.has_site()) {
        return;  // write_head says so
    }
    out.begin("[site]");
    auto const write = [&](char const* key, std::optional<std::string> const& distance, char const* what) {
        distance ? out.state(key, quoted(*distance))
                 : out.leave_out(key, "\"2 m\"", fmt::format("{} near the cask, because no distance was given", what));
    };
    write("cask", a.gap, "no other cask");
    write("wall", a.wall, "no wall");
    write("edge", a.edge, "no edge of the pad");
    if (a.height) {
        out.state("height", quoted(*a.height));
    } else if (!a.has_pallet()) {  // else that of the parts
        out.leave_out("height", "\"5.2 m\"",
                      "twice the height of the centre of gravity, because no full height was given");
    }
    out.end();
}

void write_statistics(StudyText& out, StudyAnswers const& a) {
    out.begin("[statistics]");
    a.beta_u ? out.state("beta_u", as_value(*a.beta_u))
             : out.leave_out("beta_u", "0.3",
                             "no HCLPF, because no beta_U was given (lognormal standard deviation of the median from "
                             "uncertain properties of the cask)");
    out.end();
}

}  // namespace

std::string study_command(std::string const& name, StudyAnswers const& answers) {
    auto command = "overturn new " + as_argument(name);
    for (auto const& question : study_questions()) {
        if (auto const& answer = answers.*question.answer) {
            command += fmt::format(" {} {}", question.option, as_argument(*answer));
        }
    }
    return command;
}

std::string study_text(std::string const& name, StudyAnswers const& answers) {
    StudyText out;
    write_head(out, name, answers);
    out.begin("[waves]");
    answers.spectrum ? write_drawn_waves(out, answers) : write_records(out, answers);
    if (answers.friction) {
        write_body(out, answers, "cask", "");
    } else {
        write_body(out, answers, "cask-that-slides", "0.2");
        write_body(out, answers, "cask-that-rocks", "0.8");
    }
    write_levels(out, answers);
    write_site(out, answers);
    write_statistics(out, answers);
    return out.text();
}

}  // namespace overturn
