#include "output/sheets.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "campaign/assumptions.hpp"
#include "campaign/campaign_spec.hpp"
#include "campaign/cautions.hpp"
#include "campaign/rows.hpp"
#include "campaign/validated_range.hpp"
#include "core/error.hpp"
#include "output/detail/sheet_rows.hpp"
#include "results/recount.hpp"
#include "results/schema.hpp"
#include "results/stated_levels.hpp"

namespace overturn::output {
namespace {

// What people look for first; further columns follow by name.
constexpr std::array stripes_first{"amplitude", "level",     "purpose",     "trials", "overturned", "exceeded",
                                   "failed",    "undecided", "probability", "lower",  "upper"};
constexpr std::array rare_first{"amplitude", "probability", "lower", "upper", "state", "method"};
// Those in the unit of their measure are shown in the unit of the levels too.
constexpr std::array curves_first{"measure",
                                  "units",
                                  "measure_units",
                                  "label",
                                  "title",
                                  "state",
                                  "median",
                                  "median_lower",
                                  "median_upper",
                                  "beta",
                                  "beta_lower",
                                  "beta_upper",
                                  "beta_r",
                                  "beta_u",
                                  "five_percent_point",
                                  "five_percent_point_lower",
                                  "five_percent_point_upper",
                                  "hclpf",
                                  "hclpf_lower",
                                  "hclpf_upper",
                                  "one_percent_point"};

// None: it has keys of another program, or its records are not there.
std::optional<CampaignSpec> campaign_of(store::ResultsReader const& file) {
    try {
        return parse_campaign(input_of(file));
    } catch (InputError const&) {
        return std::nullopt;
    }
}

class Sheets {
  public:
    Sheets(store::ResultsReader const& file, std::optional<CampaignSpec> const& spec)
        : file_(file),
          columns_(file.columns()),
          stated_(stated_unit_of_levels(file)),
          typed_(spec ? stated_units_of_columns(*spec) : std::map<std::string, IntensityUnit>()),
          level_units_(file.text("level_units")),
          level_measure_(file.text("level_measure")) {}

    [[nodiscard]] Sheet trials() const { return of_rows("trials", "trials/verdict", names_of<TrialRow>("trial")); }
    [[nodiscard]] Sheet waves() const { return of_rows("waves", "waves/id", names_of<WaveRow>("wave")); }
    [[nodiscard]] Sheet stripes() const {
        return of_bodies("stripes", "stripes", "amplitude", {stripes_first.begin(), stripes_first.end()});
    }
    [[nodiscard]] Sheet curves() const {
        return of_bodies("curves", "fragility", "measure", {curves_first.begin(), curves_first.end()});
    }
    /// Estimates of [rare]; without rows where the campaign asks for none.
    [[nodiscard]] Sheet rare() const {
        return of_bodies("rare", "rare", "amplitude", {rare_first.begin(), rare_first.end()});
    }

  private:
    template <class Row> static std::vector<std::string> names_of(char const* axis) {
        std::vector<std::string> names{axis};
        std::ranges::transform(fields_of<Row>(), std::back_inserter(names), &Field::name);
        return names;
    }

    [[nodiscard]] store::ColumnMeaning const* find(std::string const& path) const {
        auto const found = std::ranges::find(columns_, path, &store::ColumnMeaning::path);
        return found == columns_.end() ? nullptr : &*found;
    }

    // Columns below `group` that are as long as `long_as`, those of `first` in that order before the others. Tables of
    // bodies are of no depth: what lies in a group of theirs may be as long by chance.
    [[nodiscard]] SheetPart part_of(std::string const& group, std::string const& long_as,
                                    std::vector<std::string> const& first, bool deep) const {
        SheetPart part;
        auto const* const axis = find(long_as);
        part.rows = axis == nullptr ? 0 : axis->rows;
        std::vector<std::pair<std::size_t, store::ColumnMeaning const*>> found;
        for (auto const& column : columns_) {
            bool const below = column.path.starts_with(group + "/")
                               && (deep || column.path.find('/', group.size() + 1) == std::string::npos);
            if (axis != nullptr && below && column.rows == part.rows) {
                auto const place = std::ranges::find(first, column.path.substr(group.size() + 1)) - first.begin();
                found.emplace_back(place, &column);
            }
        }
        std::ranges::stable_sort(found, {}, [](auto const& each) { return each.first; });
        for (auto const& [place, column] : found) {
            add(part, *column, column->path.substr(group.size() + 1));
        }
        return part;
    }

    void add(SheetPart& part, store::ColumnMeaning const& column, std::string const& name) const {
        SheetSource source{
            .column = {name, column.units, column.description}, .path = column.path, .type = column.type};
        if (column.type != FieldType::real) {
            source.names = file_.categories(column.path);
            std::istringstream flags(file_.attribute_or(column.path, "flag_names", ""));
            source.flags.assign(std::istream_iterator<std::string>(flags), {});
        }
        auto const by_row = file_.attribute_or(column.path, "units_from", "");
        source.column.unit =
            by_row.empty() ? (column.units.empty() ? "1" : column.units) : fmt::format("unit in column {}", by_row);
        part.sources.push_back(source);
        auto const typed = typed_.find(column.units);
        bool const of_level = name == "amplitude" && column.units == level_units_ && stated_;
        if (typed != typed_.end() && by_row.empty() && !of_level && column.type == FieldType::real) {
            source.column.unit = typed->second.symbol;
            source.per_unit = typed->second.si;
            part.sources.push_back(std::move(source));
            return;
        }
        if (!stated_ || stated_->symbol == level_units_) {
            return;
        }
        bool const of_curve = !by_row.empty() && std::ranges::count(curves_first, name) > 0;
        if (of_curve || (name == "amplitude" && column.units == level_units_)) {
            source.column.unit = stated_->symbol;
            source.per_unit = stated_->si;
            source.only_where = of_curve ? "measure" : "";
            source.only_is = of_curve ? level_measure_ : "";
            part.sources.push_back(std::move(source));
        }
    }

    [[nodiscard]] Sheet of_rows(std::string const& group, std::string const& long_as,
                                std::vector<std::string> const& first) const {
        return sheet_of(group, file_, {part_of(group, long_as, first, true)});
    }

    // One part for each limit state and body that has such a table.
    [[nodiscard]] Sheet of_bodies(std::string const& name, std::string const& table, std::string const& axis,
                                  std::vector<std::string> const& first) const {
        std::vector<SheetPart> parts;
        for (auto const& limit : limits()) {
            for (auto const& body : file_.categories("trials/body")) {
                auto const group = group_of(table, body.name, limit);
                auto part = part_of(group, fmt::format("{}/{}", group, axis), first, false);
                part.sources.insert(part.sources.begin(),
                                    {{.column = {"body", "1", "name of the body"}, .text = body.name},
                                     {.column = {"limit", "1", "name of the limit state"}, .text = limit}});
                parts.push_back(std::move(part));
            }
        }
        return sheet_of(name, file_, std::move(parts));
    }

    [[nodiscard]] std::vector<std::string> limits() const {
        auto const* const listed = find("limit_states/name");
        bool const numbered = listed != nullptr && listed->rows >= 0;
        auto names = numbered ? file_.texts("limit_states/name") : file_.members("limits");
        if (std::ranges::find(names, overturning_limit) == names.end()) {
            names.insert(names.begin(), overturning_limit);
        }
        return names;
    }

    store::ResultsReader const& file_;
    std::vector<store::ColumnMeaning> columns_;
    std::optional<IntensityUnit> stated_;         ///< of levels
    std::map<std::string, IntensityUnit> typed_;  ///< of columns, by their SI unit
    std::string level_units_, level_measure_;
};

Sheet meanings_of(std::vector<Sheet> const& sheets) {
    std::vector<std::vector<std::string>> rows;
    for (auto const& sheet : sheets) {
        for (auto const& column : sheet.columns) {
            rows.push_back({sheet.name, column.name, column.unit == "1" ? "" : column.unit, column.meaning});
        }
    }
    return text_sheet("columns", {{"table", "1", ""}, {"column", "1", ""}, {"unit", "1", ""}, {"meaning", "1", ""}},
                      std::move(rows));
}

// What the numbers depend on, as the answer says it.
void add_dependence(std::vector<std::vector<std::string>>& rows, std::optional<CampaignSpec> const& spec) {
    if (!spec) {
        rows.push_back({"caution", "what is assumed and validated is not known: overturn fit says why"});
        return;
    }
    rows.push_back({"confidence", fmt::format("{:g}", spec->confidence)});
    rows.push_back({"assumed", assumed_text(physical_inputs(*spec))});
    rows.push_back({"validated_range", validated_range_text(*spec, spec->bodies.size())});
    for (auto const& caution : cautions_of(*spec)) {
        rows.push_back({"caution", caution});
    }
}

Sheet about(store::ResultsReader const& file, std::optional<CampaignSpec> const& spec) {
    std::vector<std::vector<std::string>> rows;
    for (auto const* const name : {"title", "campaign_name", "content_sha256", "program_version", "git_revision",
                                   "level_measure", "wave_source"}) {
        rows.push_back({name, file.text(name)});
    }
    for (auto const* const name : {"settings", "variability"}) {  // not in the oldest files
        if (auto const text = file.attribute_or("/", name, ""); !text.empty()) {
            rows.push_back({name, text});
        }
    }
    rows.push_back({"seed", fmt::format("{}", file.integer("seed"))});
    rows.push_back({"format_version", fmt::format("{}", file.integer("format_version"))});
    add_dependence(rows, spec);
    return text_sheet("about", {{"name", "1", ""}, {"value", "1", ""}}, std::move(rows));
}

}  // namespace

std::vector<Sheet> sheets_of(store::ResultsReader const& file) {
    validate(file.integer("complete") == 1,
             "results file: not complete (its run did not end). Go on with overturn run --resume");
    auto const spec = campaign_of(file);
    Sheets const tables(file, spec);
    std::vector<Sheet> sheets{tables.trials(), tables.waves(), tables.stripes(), tables.curves()};
    if (auto rare = tables.rare(); rare.rows > 0) {
        sheets.push_back(std::move(rare));
    }
    sheets.push_back(meanings_of(sheets));
    sheets.push_back(about(file, spec));
    return sheets;
}

}  // namespace overturn::output
