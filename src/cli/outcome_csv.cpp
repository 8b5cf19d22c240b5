#include "cli/outcome_csv.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "config/suggestion.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "motion/cell_rows.hpp"
#include "motion/text_lines.hpp"
#include "motion/text_statements.hpp"

namespace overturn::cli {
namespace {

// A * stands for any letters; at most one.
bool fits(std::string_view pattern, std::string_view name) {
    auto const star = pattern.find('*');
    if (star == std::string_view::npos) {
        return pattern == name;
    }
    return name.size() + 1 >= pattern.size() && name.starts_with(pattern.substr(0, star))
           && name.ends_with(pattern.substr(star + 1));
}

std::vector<std::size_t> bodies_of(std::string_view pattern, CampaignSpec const& spec) {
    std::vector<std::size_t> found;
    for (std::size_t b = 0; b < spec.bodies.size(); ++b) {
        if (fits(pattern, spec.bodies[b].name)) {
            found.push_back(b);
        }
    }
    return found;
}

class Reader {
  public:
    Reader(std::string const& text, std::string const& file, CampaignSpec const& spec, Plan const& plan)
        : rows_(text, file, "Begin with wave,motion and a body's name"), spec_(spec) {
        std::size_t const waves = plan.waves();
        outcomes_.records.reserve(waves);
        for (std::size_t w = 0; w < waves; ++w) {
            outcomes_.records.push_back(spec.source->name(plan.wave_id(w)));
        }
        given_.resize(waves);
        outcomes_.motions.resize(waves);
    }

    [[nodiscard]] Outcomes outcomes() {
        read_header(rows_.header());
        bool any = false;
        while (auto const cells = rows_.next()) {
            read_row(*cells);
            any = true;
        }
        if (!any) {
            rows_.fail("no test (a header alone). Add a row for each wave tested");
        }
        TextStatements statements(Dimension::none);
        statements.take(rows_.text(), 0);
        outcomes_.unread = statements.unread();
        return std::move(outcomes_);
    }

  private:
    // Where the columns stand.
    struct Header {
        std::optional<std::size_t> wave, motion;
        std::vector<std::size_t> specimens;  // as in outcomes_
    };

    void read_header(std::vector<Cell> const& cells) {
        for (std::size_t c = 0; c < cells.size(); ++c) {
            auto const name = cells[c].text;
            if (name == "wave" || name == "motion") {
                auto& place = name == "wave" ? header_.wave : header_.motion;
                if (place) {
                    rows_.fail(cells[c], fmt::format("column '{}' twice (which one counts?). Remove one", name));
                }
                place = c;
            } else {
                add_specimen(cells[c]);
                header_.specimens.push_back(c);
            }
        }
        if (!header_.wave) {
            rows_.fail(cells.front(),
                       "no column 'wave' (which motion was it?). Add the wave's number, or its record's name");
        }
        if (header_.specimens.empty()) {
            rows_.fail(cells.back(),
                       fmt::format("no column of outcomes (nothing to compare with). Add one named as a body: {}",
                                   config::joined(names_of(spec_.bodies))));
        }
    }

    void add_specimen(Cell const& cell) {
        auto bodies = bodies_of(cell.text, spec_);
        if (bodies.empty()) {
            rows_.fail(cell, fmt::format("column {} (no body is named so). {}", in_quotes(cell.text),
                                         config::suggestion(cell.text, names_of(spec_.bodies))));
        }
        for (auto const& other : outcomes_.specimens) {
            if (other.name == cell.text) {
                rows_.fail(cell, fmt::format("column {} twice (which one counts?). Remove one", in_quotes(cell.text)));
            }
        }
        outcomes_.specimens.push_back(
            {std::string(cell.text), std::move(bodies), std::vector<Outcome>(given_.size(), Outcome::untested)});
    }

    void read_row(std::vector<Cell> const& cells) {
        auto const wave = wave_of(cells[*header_.wave]);
        if (given_[wave]) {
            rows_.fail(cells[*header_.wave], fmt::format("wave {} twice (a wave is one test). Remove one row",
                                                         in_quotes(cells[*header_.wave].text)));
        }
        given_[wave] = true;
        outcomes_.motions[wave] =
            header_.motion ? std::string(cells[*header_.motion].text) : fmt::format("wave {}", wave);
        if (outcomes_.motions[wave].empty()) {
            rows_.fail(cells[*header_.motion], "no motion (tests of one motion are judged together). Name it");
        }
        for (std::size_t s = 0; s < header_.specimens.size(); ++s) {
            outcomes_.specimens[s].outcomes[wave] = outcome_of(cells[header_.specimens[s]]);
        }
    }

    [[nodiscard]] std::size_t wave_of(Cell const& cell) const {
        auto const& records = outcomes_.records;
        auto const named = std::ranges::find(records, cell.text);
        if (named != records.end() && !cell.text.empty()) {
            return static_cast<std::size_t>(named - records.begin());
        }
        auto const is_file = [&](std::string const& name) {
            return !name.empty() && std::filesystem::path(name).filename() == cell.text;
        };
        if (std::ranges::count_if(records, is_file) == 1) {
            return static_cast<std::size_t>(std::ranges::find_if(records, is_file) - records.begin());
        }
        double number = -1;
        if (!parse_number(cell.text, number)
            || !(number >= 0 && number < static_cast<double>(records.size()) && number == std::floor(number))) {
            rows_.fail(cell,
                       fmt::format("wave {} (neither a record of the campaign nor a number from 0 to {}). Name one",
                                   in_quotes(cell.text), records.size() - 1));
        }
        return static_cast<std::size_t>(number);
    }

    [[nodiscard]] Outcome outcome_of(Cell const& cell) const {
        if (cell.text.empty()) {
            return Outcome::untested;
        }
        if (cell.text != "0" && cell.text != "1") {
            rows_.fail(
                cell, fmt::format("{} (not an outcome). Write 1 for overturned, 0 for stood; leave empty if not tested",
                                  in_quotes(cell.text)));
        }
        return cell.text == "1" ? Outcome::fell : Outcome::stood;
    }

    CellRows rows_;
    CampaignSpec const& spec_;
    std::vector<bool> given_;  // by wave
    Header header_;
    Outcomes outcomes_;
};

// Outcomes are of motions as they were measured.
std::size_t level_as_measured(std::string const& file, CampaignSpec const& spec) {
    if (spec.levels.measure == measure_named("factor") && !spec.levels.independent_waves) {
        for (std::size_t l = 0; l < spec.levels.levels.size(); ++l) {
            if (spec.levels.levels[l].value == 1) {
                return l;
            }
        }
    }
    throw InputError({file, 0, 0},
                     "outcomes of a campaign without the motions as they were measured (levels scale them). "
                     "Run it with measure = \"factor\" and 1 among the values of [levels]");
}

}  // namespace

Outcomes parse_outcomes(std::string const& text, std::string const& file, CampaignSpec const& spec, Plan const& plan) {
    auto const level = level_as_measured(file, spec);
    auto outcomes = Reader(text, file, spec, plan).outcomes();
    outcomes.level = level;
    return outcomes;
}

}  // namespace overturn::cli
