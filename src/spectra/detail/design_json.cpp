#include "spectra/detail/design_json.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/units.hpp"
#include "motion/text_lines.hpp"
#include "spectra/detail/design_part.hpp"
#include "spectra/detail/json_statements.hpp"

namespace overturn {
namespace {

using Json = nlohmann::ordered_json;
using Text = std::string_view;

constexpr int deepest = 16;  // nothing real nests deeper than a few

struct Spectrum {
    std::string name;
    Json const* at = nullptr;  ///< the object of its arrays, or its array of pairs
    std::vector<Pair> points;
};

bool is_number_list(Json const& value) {
    return value.is_array() && !value.empty() && std::ranges::all_of(value, &Json::is_number);
}

bool is_pair_list(Json const& value) {
    constexpr std::size_t two = 2;
    return value.is_array() && value.size() >= two
           && std::ranges::all_of(value, [](Json const& each) { return is_number_list(each) && each.size() == two; });
}

/// All below `value`, in its order. \param depth of what the caller stands at
void collect(Json const& value, std::string const& name, int depth, std::vector<Spectrum>& found) {
    if (depth > deepest || !value.is_object()) {
        return;
    }
    auto const periods = value.find("periods");
    auto const ordinates = value.find("ordinates");
    if (periods != value.end() && ordinates != value.end() && is_number_list(*periods) && is_number_list(*ordinates)
        && periods->size() == ordinates->size()) {
        Spectrum spectrum{name, &value, {}};
        for (std::size_t i = 0; i < periods->size(); ++i) {
            spectrum.points.emplace_back((*periods)[i].get<double>(), (*ordinates)[i].get<double>());
        }
        found.push_back(std::move(spectrum));
    }
    for (auto const& [key, each] : value.items()) {
        if (is_pair_list(each) && lowered(key).find("spectrum") != std::string::npos) {
            Spectrum spectrum{key, &each, {}};
            for (auto const& pair : each) {
                spectrum.points.emplace_back(pair[0].get<double>(), pair[1].get<double>());
            }
            found.push_back(std::move(spectrum));
        } else {
            collect(each, key, depth + 1, found);
        }
    }
}

/// Finds keys in the text in the order in which they are asked for.
class KeyLines {
  public:
    explicit KeyLines(Text content) : content_(content) {}

    /// The key's line; that of the one before it where it is written otherwise than here, with escapes.
    int of(std::string const& key) {
        auto const quoted = Json(key).dump(-1, ' ', false, Json::error_handler_t::replace);
        for (auto at = content_.find(quoted, at_); at != Text::npos; at = content_.find(quoted, at + 1)) {
            auto const behind = content_.find_first_not_of(" \t\r\n", at + quoted.size());
            if (behind != Text::npos && content_[behind] == ':') {
                line_ += static_cast<int>(std::ranges::count(content_.substr(at_, at - at_), '\n'));
                at_ = at;
                break;
            }
        }
        return line_;
    }

  private:
    Text content_;
    std::size_t at_ = 0;
    int line_ = 1;
};

/// What stands beside a spectrum and above it, but not beside another one.
class Beside {
  public:
    Beside(Text content, std::vector<Spectrum> const& all, Spectrum const& own, TargetKind kind, PairTable& table)
        : lines_(content), all_(all), own_(own), kind_(kind), table_(table) {}

    void take(Json const& value) { take(value, true, 0); }

  private:
    [[nodiscard]] static bool holds(Json const& value, Spectrum const& spectrum, int depth) {
        return &value == spectrum.at
               || (depth <= deepest && value.is_object()
                   && std::ranges::any_of(value, [&](Json const& each) { return holds(each, spectrum, depth + 1); }));
    }

    void take(Json const& value, bool counts, int depth) {
        if (depth > deepest) {
            return;
        }
        bool const above = holds(value, own_, depth);
        for (auto const& [key, each] : value.items()) {
            auto const line = lines_.of(key);
            bool const leads = holds(each, own_, depth);
            bool const to_other = !leads && std::ranges::any_of(all_, [&, &beside = each](Spectrum const& spectrum) {
                return holds(beside, spectrum, depth);
            });
            if (leads) {
                take_name(key, line);
            }
            keys_ = above ? std::vector<std::string>{} : keys_;
            keys_.push_back(key);
            if (each.is_object()) {
                auto const kept = keys_;
                take(each, counts && !to_other, depth + 1);
                keys_ = kept;
            } else if (counts && !leads && !to_other && !is_own_list(key, value)) {
                take_statement(each, line);
            }
            keys_.pop_back();
        }
    }

    [[nodiscard]] bool is_own_list(Text key, Json const& value) const {
        return &value == own_.at && (key == "periods" || key == "ordinates");
    }

    void take_name(std::string const& key, int line) {
        table_.names_line = line;
        auto const words = words_of_key(key);
        if (tells_of_spectrum(words)) {
            table_.text.push_back({words, line});
        }
    }

    void take_statement(Json const& value, int line) {
        auto statement = json_statement(keys_, value, kind_);
        if (!statement.text.empty()) {
            table_.text.push_back({std::move(statement.text), line});
        }
        if (!statement.period_unit.empty()) {
            table_.first_name = fmt::format("T ({})", statement.period_unit);
        }
    }

    KeyLines lines_;
    std::vector<Spectrum> const& all_;
    Spectrum const& own_;
    TargetKind kind_;
    PairTable& table_;
    std::vector<std::string> keys_;
};

Spectrum const& chosen(std::vector<Spectrum> const& found, std::string const& part, std::string const& file) {
    if (found.empty()) {
        throw InputError({file},
                         "JSON without a spectrum (arrays periods and ordinates, or pairs under a name that "
                         "holds 'spectrum'). Write columns T (s),Sa (g)");
    }
    std::vector<std::string> names;
    std::ranges::transform(found, std::back_inserter(names), &Spectrum::name);
    return found[part_among(names, part, "spectra", {file})];
}

/// \throws InputError at what is no JSON, or says a key of one object twice
Json parsed(Text content, std::string const& name) {
    std::vector<std::vector<std::string>> keys;
    auto const each_once = [&](int /*depth*/, Json::parse_event_t event, Json& value) {
        if (event == Json::parse_event_t::object_start) {
            keys.emplace_back();
        } else if (event == Json::parse_event_t::object_end) {
            keys.pop_back();
        } else if (event == Json::parse_event_t::key) {
            auto key = value.get<std::string>();
            if (std::ranges::find(keys.back(), key) != keys.back().end()) {
                throw InputError({name},
                                 fmt::format("{} twice in one object (which counts?). Keep one", in_quotes(key)));
            }
            keys.back().push_back(std::move(key));
        }
        return true;
    };
    auto json = Json::parse(content, each_once, false);
    if (json.is_discarded()) {
        throw InputError({name}, "no JSON that can be read, though it begins like one (cut short?). Fetch it anew");
    }
    return json;
}

}  // namespace

bool is_json(std::string_view content) {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    content.remove_prefix(content.starts_with(byte_order_mark) ? byte_order_mark.size() : 0);
    return trimmed(content).starts_with('{');
}

PairTable table_of_design_json(std::string_view content, std::string const& name, std::string const& part,
                               TargetKind kind) {
    auto const json = parsed(content, name);
    std::vector<Spectrum> found;
    collect(json, "spectrum", 0, found);
    auto const& spectrum = chosen(found, part, name);
    auto const lower = lowered(content);
    bool const of_usgs = lower.find("referencedocument") != std::string::npos
                         || lower.find("earthquake.usgs.gov/ws/designmaps") != std::string::npos;
    PairTable table{spectrum.points, "T (s)", of_usgs ? "Sa (g)" : "ordinates", 1, {}, {}};
    Beside(content, found, spectrum, kind, table).take(json);
    table.line.assign(table.points.size(), table.names_line);
    return table;
}

}  // namespace overturn
