// Tables held to the description of their keys: the readers that take a key, and the check of all that is read.
#include <algorithm>

#include <fmt/format.h>

#include "config/detail/table_node.hpp"

namespace overturn::config {
namespace {

[[noreturn]] void broken(std::string const& key, std::string_view what) {
    throw ContractError(fmt::format("{}: {}", key, what));
}

bool lies_within(Range const& inner, Range const& outer) {
    bool const above = inner.low > outer.low || (inner.low == outer.low && (inner.low_open || !outer.low_open));
    bool const below = inner.high < outer.high || (inner.high == outer.high && (inner.high_open || !outer.high_open));
    return above && below;
}

bool is_same(Default const& stated, Default const& taken) {
    return stated.number == taken.number && stated.integer == taken.integer && stated.boolean == taken.boolean
           && stated.words == taken.words;
}

}  // namespace

void Table::described_by(KeyTable const& description) const { node_->described = {&description}; }

void Table::may_have(KeyTable const& keys) const {
    node_->complete = true;
    for (auto const* key : keys.every_key()) {
        node_->asked.emplace(key->name);
    }
}

std::vector<Key const*> Table::Node::descriptions(std::string_view key) const {
    std::vector<Key const*> found;
    for (auto const* candidate : described) {
        if (auto const* one = candidate->find(key)) {
            found.push_back(one);
        }
    }
    return found;
}

std::vector<KeyTable const*> Table::Node::tables_at(std::string_view key) const {
    std::vector<KeyTable const*> tables;
    for (auto const* found : descriptions(key.substr(0, key.find('[')))) {  // "bodies[1]" is described as "bodies"
        if (found->tables != nullptr) {
            auto const these = found->tables();
            tables.insert(tables.end(), these.begin(), these.end());
        }
    }
    return tables;
}

std::string Table::Node::further_down(std::string_view key) const {
    std::set<std::string> places;
    for (auto const* candidate : described) {
        for (auto const* inner : candidate->every_key()) {
            for (auto const* below : inner->tables == nullptr ? std::vector<KeyTable const*>() : inner->tables()) {
                if (below->find(key) != nullptr) {
                    places.insert(fmt::format("{}.{}", inner->name, key));
                }
            }
        }
    }
    return places.size() == 1 ? *places.begin() : std::string();
}

void Table::Node::check_read(std::string_view key, Form form, std::optional<Dimension> dimension,
                             std::optional<Range> range) const {
    if (!OVERTURN_CHECKED || described.empty()) {
        return;
    }
    auto const found = descriptions(key);
    if (found.empty()) {
        broken(full(key), "read, but not described as a key of its table");
    }
    bool const fits = std::ranges::any_of(found, [&](Key const* one) {
        bool const as_text = form == Form::text && (one->takes(Form::word) || one->takes(Form::number));
        bool const of_dimension = !dimension || !one->dimension_of.empty() || *dimension == one->dimension;
        return (one->takes(form) || as_text) && of_dimension && (!range || lies_within(*range, one->range));
    });
    if (!fits) {
        broken(full(key), "read as another form, in another unit or in a wider range than it is described with");
    }
}

void Table::Node::check_default(std::string_view key, Default const& taken) const {
    if (!OVERTURN_CHECKED || described.empty()) {
        return;
    }
    auto const found = descriptions(key);
    bool const fits = std::ranges::any_of(found, [&](Key const* one) {
        return one->absent.kind == Default::Kind::value ? is_same(one->absent, taken)
                                                        : one->absent.kind != Default::Kind::required;
    });
    if (!fits) {
        broken(full(key), found.empty() ? "read, but not described as a key of its table"
                                        : "has another default than it is described with");
    }
}

double Table::number(Key const& key, Given const& given) const {
    auto const dimension = given.dimension.value_or(key.dimension);
    auto const range = given.range.value_or(key.range);
    auto const otherwise = given.otherwise ? given.otherwise : key.absent.number;
    return otherwise ? number(key.name, dimension, range, *otherwise) : number(key.name, dimension, range);
}

std::optional<double> Table::maybe_number(Key const& key, Given const& given) const {
    return maybe_number(key.name, given.dimension.value_or(key.dimension), given.range.value_or(key.range));
}

std::vector<double> Table::numbers(Key const& key, Given const& given) const {
    return numbers(key.name, given.dimension.value_or(key.dimension), given.range.value_or(key.range));
}

std::vector<std::pair<double, double>> Table::pairs(Key const& key, Given const& given) const {
    return pairs(key.name, key.first, given.dimension.value_or(key.dimension));
}

std::int64_t Table::integer(Key const& key, GivenInteger const& given) const {
    auto const least = given.least.value_or(key.least);
    auto const most = given.most.value_or(key.most);
    auto const otherwise = given.otherwise ? given.otherwise : key.absent.integer;
    return otherwise ? integer(key.name, least, most, *otherwise) : integer(key.name, least, most);
}

bool Table::boolean(Key const& key) const { return boolean(key.name, key.absent.boolean.value_or(false)); }

std::string Table::text(Key const& key, std::string_view otherwise) const {
    if (key.absent.kind == Default::Kind::required) {
        return text(key.name);
    }
    return text(key.name, key.absent.kind == Default::Kind::value ? key.absent.words : otherwise);
}

void Table::take_default_word(std::string_view key, std::string_view word) const {
    node_->check_default(key, {.kind = Default::Kind::value, .words = word});
    keep_default(key, std::string(word));
}

std::vector<std::string> Table::texts(Key const& key) const { return texts(key.name); }

}  // namespace overturn::config
