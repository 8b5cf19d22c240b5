#include "config/table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <toml++/toml.h>

#include "config/detail/settings.hpp"
#include "config/detail/table_node.hpp"

namespace overturn::config {
namespace {

std::string_view kind_name(toml::node const& node) {
    if (node.is_number()) {
        return "a number";
    }
    if (node.is_string()) {
        return "a text";
    }
    if (node.is_boolean()) {
        return "true or false";
    }
    return node.is_array() ? "a list" : node.is_table() ? "a table" : "a date";
}

// What stands in place of a number: a text as it is written, which may be a setting that had no quotes.
std::string shown_kind(toml::node const& node) {
    auto const text = node.value_exact<std::string>();
    return text ? fmt::format("a text, '{}'", *text) : std::string(kind_name(node));
}

std::string_view whole_number_advice(toml::node const& node) {
    auto const text = node.value_exact<std::string>();
    bool const whole = text && !text->empty() && text->find_first_not_of("0123456789") == std::string::npos;
    return whole ? "Write it without quotes" : node.is_number() ? "Write it without a point" : "Write one, such as 10";
}

// A setting of the command line that is no number of TOML's, and taken for a text therefore.
bool is_huge_integer(std::string_view text) {
    auto const digits = text.substr(text.starts_with('-') || text.starts_with('+') ? 1 : 0);
    std::int64_t value = 0;
    return !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos
           && std::from_chars(digits.data(), digits.data() + digits.size(), value).ec == std::errc::result_out_of_range;
}

}  // namespace

double quantity_of(toml::node const& node, Dimension dimension) {
    if (auto const text = node.value_exact<std::string>()) {
        return parse_quantity(*text, dimension);
    }
    validate(
        node.is_number(), "{} (must be a number{}). Write one", kind_name(node),
        dimension == Dimension::none ? "" : " or a quantity such as \"1.5 " + std::string(si_symbol(dimension)) + "\"");
    double const value = *node.value<double>();
    validate(std::isfinite(value), "{} (must be finite). Give a finite number", value);
    return value;
}

Table Table::parse(std::string_view text, std::string file) { return parse(text, std::move(file), {}); }

Table Table::parse(std::string_view text, std::string file, std::span<std::string const> settings) {
    auto node = std::make_shared<Node>();
    node->file = std::move(file);
    node->ledger = std::make_shared<Ledger>();
    try {
        node->document = std::make_shared<toml::table>(toml::parse(text, node->file));
    } catch (toml::parse_error const& error) {
        auto const begin = error.source().begin;
        throw InputError({node->file, static_cast<int>(begin.line), static_cast<int>(begin.column)},
                         fmt::format("{} (not valid TOML). Mend the line", error.description()));
    }
    for (auto const& setting : settings) {
        apply_setting(*node->document, setting);
    }
    node->table = node->document.get();
    return Table(std::move(node));
}

Kind Table::kind(std::string_view key) const {
    node_->asked.emplace(key);
    auto const* found = value_in(node_->table->get(key));
    if (found == nullptr) {
        return Kind::absent;
    }
    if (found->is_number()) {
        return Kind::number;
    }
    if (found->is_string()) {
        return Kind::text;
    }
    if (found->is_boolean()) {
        return Kind::boolean;
    }
    return found->is_array() ? Kind::list : Kind::table;
}

namespace {

template <class Read> auto read_key(Table const& table, std::string_view key, toml::node const* node, Read&& read) {
    if (node == nullptr) {
        table.fail_missing(key);
    }
    try {
        return read(*node);
    } catch (InputError const& error) {
        table.fail(key, error.what());
    }
}

/// \param node as written, which is printed as well: "-3 t" where the value is -3000 kg
void check_range(double value, toml::node const& node, Range const& range, Dimension dimension) {
    if (range.holds(value)) {
        return;
    }
    auto const unit = si_symbol(dimension);
    auto const si = fmt::format("{}{}{}", value, unit.empty() ? "" : " ", unit);
    auto const written = std::string(trimmed(node.value_exact<std::string>().value_or(si)));
    throw InputError(fmt::format("{}{} (must be {}{}{}). State a value in this range", written,
                                 written == si ? "" : fmt::format(", that is {}", si), range.text(),
                                 unit.empty() ? "" : " ", unit));
}

/// "{distribution = ...} or {static = ...}", by the first key of each.
std::string table_forms(std::vector<KeyTable const*> const& tables) {
    std::string forms;
    for (auto const* table : tables) {
        forms += fmt::format("{}{{{} = ...}}", forms.empty() ? "" : " or ", table->keys.front().name);
    }
    return forms;
}

/// What is written at one place of a list.
struct Written {
    std::string text;
    bool with_unit = false, bare = false;  ///< 0 is the same in every unit
};

Written written(toml::node const& node) {
    if (auto const text = node.value_exact<std::string>()) {
        bool const unit = trimmed(*text).find_first_of(" \t") != std::string_view::npos;
        return {*text, unit, !unit};
    }
    double const value = node.value<double>().value_or(0);
    return {fmt::format("{}", value), false, value != 0};
}

// Of a list's numbers some with a unit and some without one.
void refuse_mixed(std::vector<Written> const& list, Dimension dimension) {
    auto const unit = std::ranges::find(list, true, &Written::with_unit);
    auto const bare = std::ranges::find(list, true, &Written::bare);
    validate(dimension == Dimension::none || unit == list.end() || bare == list.end(),
             "{} without a unit beside {} (a bare number is {}). Write its unit", bare == list.end() ? "" : bare->text,
             unit == list.end() ? "" : unit->text, si_symbol(dimension));
}

}  // namespace

double Table::number(std::string_view key, Dimension dimension, Range range) const {
    node_->check_read(key, Form::number, dimension, range);
    return read_key(*this, key, node_->find(key), [&](toml::node const& node) {
        auto const tables = node_->tables_at(key);
        validate(node.is_number() || node.is_string() || tables.empty(),
                 "{} (must be a number, or a table: {}). Write one", kind_name(node), table_forms(tables));
        double const value = quantity_of(node, dimension);
        check_range(value, node, range, dimension);
        node_->keep(key, node, value, dimension);
        return value;
    });
}

double Table::number(std::string_view key, Dimension dimension, Range range, double otherwise) const {
    node_->check_default(key, {.kind = Default::Kind::value, .number = otherwise});
    if (has(key)) {
        return number(key, dimension, range);
    }
    if (std::isfinite(otherwise)) {  // else nothing is taken for granted
        auto const unit = si_symbol(dimension);
        keep_default(key, fmt::format("{:.6g}{}{}", otherwise, unit.empty() ? "" : " ", unit));
    }
    return otherwise;
}

std::optional<double> Table::maybe_number(std::string_view key, Dimension dimension, Range range) const {
    return has(key) ? std::optional(number(key, dimension, range)) : std::nullopt;
}

std::vector<double> Table::numbers(std::string_view key, Dimension dimension, Range range) const {
    node_->check_read(key, Form::numbers, dimension, range);
    return read_key(*this, key, node_->find(key), [&](toml::node const& node) {
        validate(node.is_array(), "{} (must be a list of numbers). Write [1, 2]", kind_name(node));
        std::vector<double> values;
        for (auto const& element : *node.as_array()) {
            values.push_back(quantity_of(element, dimension));
            check_range(values.back(), element, range, dimension);
        }
        node_->keep(key, node, {}, dimension);
        return values;
    });
}

std::vector<std::pair<double, double>> Table::pairs(std::string_view key, Dimension first, Dimension second) const {
    node_->check_read(key, Form::pairs, second);
    return read_key(*this, key, node_->find(key), [&](toml::node const& node) {
        validate(node.is_array(), "{} (must be a list of [x, y] pairs). Write [[1, 2], [3, 4]]", kind_name(node));
        std::vector<std::pair<double, double>> values;
        std::vector<Written> firsts;
        std::vector<Written> seconds;
        for (auto const& element : *node.as_array()) {
            auto const* pair = element.as_array();
            if (pair == nullptr || pair->size() != 2) {
                throw InputError(fmt::format("entry {} (must be a pair [x, y]). Mend it", values.size() + 1));
            }
            values.emplace_back(quantity_of(*pair->get(0), first), quantity_of(*pair->get(1), second));
            firsts.push_back(written(*pair->get(0)));
            seconds.push_back(written(*pair->get(1)));
        }
        refuse_mixed(firsts, first);
        refuse_mixed(seconds, second);
        node_->keep(key, node, {}, second);
        return values;
    });
}

std::int64_t Table::integer(std::string_view key, std::int64_t low, std::int64_t high) const {
    node_->check_read(key, Form::integer);
    return read_key(*this, key, node_->find(key), [&](toml::node const& node) {
        auto const value = node.value_exact<std::int64_t>();
        if (auto const text = node.value_exact<std::string>(); text && is_huge_integer(*text)) {
            throw InputError(fmt::format("{} (must be {} to {}). State a value in this range", *text, low, high));
        }
        validate(value.has_value(), "{} (must be a whole number). {}", shown_kind(node), whole_number_advice(node));
        validate(*value >= low && *value <= high, "{} (must be {} to {}). State a value in this range", *value, low,
                 high);
        node_->keep(key, node, {}, Dimension::none);
        return *value;
    });
}

std::int64_t Table::integer(std::string_view key, std::int64_t low, std::int64_t high, std::int64_t otherwise) const {
    node_->check_default(key, {.kind = Default::Kind::value, .integer = otherwise});
    if (has(key)) {
        return integer(key, low, high);
    }
    keep_default(key, fmt::format("{}", otherwise));
    return otherwise;
}

bool Table::boolean(std::string_view key, bool otherwise) const {
    node_->check_read(key, Form::boolean);
    node_->check_default(key, {.kind = Default::Kind::value, .boolean = otherwise});
    if (!has(key)) {
        keep_default(key, otherwise ? "true" : "false");
        return otherwise;
    }
    return read_key(*this, key, node_->find(key), [&](toml::node const& node) {
        auto const value = node.value_exact<bool>();
        auto const text = node.value_exact<std::string>();
        validate(value.has_value(), "{} (must be true or false). Write {}", shown_kind(node),
                 text == "true" || text == "false" ? "it without quotes" : "one of the two");
        node_->keep(key, node, {}, Dimension::none);
        return *value;
    });
}

std::string Table::text(std::string_view key) const {
    node_->check_read(key, Form::text);
    return read_key(*this, key, node_->find(key), [&](toml::node const& node) {
        auto const value = node.value_exact<std::string>();
        validate(value.has_value(), "{} (must be a text). Put it in quotes", kind_name(node));
        node_->keep(key, node, {}, Dimension::none);
        return *value;
    });
}

std::string Table::text(std::string_view key, std::string_view otherwise) const {
    node_->check_default(key, {.kind = Default::Kind::value, .words = otherwise});
    if (has(key)) {
        return text(key);
    }
    if (!otherwise.empty()) {
        keep_default(key, std::string(otherwise));
    }
    return std::string(otherwise);
}

std::vector<std::string> Table::texts(std::string_view key) const {
    node_->check_read(key, Form::texts);
    return read_key(*this, key, node_->find(key), [&](toml::node const& node) {
        validate(node.is_array(), R"({} (must be a list of texts). Write ["one", "two"])", kind_name(node));
        std::vector<std::string> values;
        for (auto const& element : *node.as_array()) {
            auto const value = element.value_exact<std::string>();
            validate(value.has_value(), "entry {} is {} (must be a text). Put it in quotes", values.size() + 1,
                     kind_name(element));
            values.push_back(*value);
        }
        node_->keep(key, node, {}, Dimension::none);
        return values;
    });
}

Table Table::child(std::string_view key) const {
    node_->check_read(key, Form::table);
    return read_key(*this, key, node_->find(key), [&](toml::node const& node) {
        validate(node.is_table(), "{} (must be a table). Write its keys in braces or under its own heading",
                 kind_name(node));
        return Table(node_->below(key, *node.as_table(), {}));
    });
}

Table Table::child_or_empty(std::string_view key) const {
    if (has(key)) {
        return child(key);
    }
    auto nothing = Table::parse("", node_->file);
    nothing.node_->ledger = node_->ledger;
    nothing.node_->ledger_path = node_->ledger_key(key);
    nothing.node_->depth = node_->depth;
    nothing.node_->described = node_->tables_at(key);
    return nothing;
}

std::vector<Table> Table::children(std::string_view key) const {
    node_->check_read(key, Form::tables);
    return read_key(*this, key, node_->find(key), [&](toml::node const& node) {
        validate(node.is_array(), "{} (must be a list of tables). Write [[{}]]", kind_name(node), key);
        std::vector<Table> tables;
        for (auto const& element : *node.as_array()) {
            validate(element.is_table(), "{}[{}] is {} (must be a table). Write [[{}]]", key, tables.size(),
                     kind_name(element), key);
            tables.push_back(Table(node_->below(key, *element.as_table(), tables.size())));
        }
        return tables;
    });
}

}  // namespace overturn::config
