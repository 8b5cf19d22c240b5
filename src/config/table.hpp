/// The door where TOML enters: typed, range-checked and audited. Every key is read by somebody or is an error.
#pragma once

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config/input_value.hpp"
#include "config/key.hpp"
#include "config/range.hpp"
#include "config/registry.hpp"
#include "core/error.hpp"
#include "core/units.hpp"

namespace overturn::config {

/// Type of a key's value.
enum class Kind { absent, number, text, boolean, list, table };

/// Default, range and dimension of a number that are known only when it is read; its key describes the rest.
struct Given {
    std::optional<double> otherwise = {};     ///< [SI] of a key whose default is stated in words
    std::optional<Range> range = {};          ///< within that of the key
    std::optional<Dimension> dimension = {};  ///< of a key whose unit is that of another
};

/// The same for a whole number.
struct GivenInteger {
    std::optional<std::int64_t> otherwise = {}, least = {}, most = {};
};

/// Something in a file that is not as it is described.
struct Fault {
    Location where;
    bool missing = false;  ///< a key that must be there; else one that is there
    std::string text;      ///< as of an InputError
};

/// One TOML table. Copies share the record of which keys were read; call finish() when all have been.
/// All readers throw InputError with the key's place in the file; a quantity may be a bare SI number or "1.5 unit".
class Table {
  public:
    /// \param file the name shown in messages. \throws InputError on a syntax error.
    [[nodiscard]] static Table parse(std::string_view text, std::string file);

    /// The same with "key.sub=value" settings applied on top (`bodies.0.friction=0.5` reaches into an array).
    [[nodiscard]] static Table parse(std::string_view text, std::string file, std::span<std::string const> settings);

    [[nodiscard]] bool has(std::string_view key) const { return kind(key) != Kind::absent; }
    [[nodiscard]] Kind kind(std::string_view key) const;

    /// Holds every value read from this table, from tables in it and from documents it names to what is described:
    /// a key that is not, or that is read as something else, is a ContractError.
    void described_by(KeyTable const& description) const;

    /// \name Readers of described keys: the key says unit, range and default.
    /// @{
    [[nodiscard]] double number(Key const& key, Given const& given = {}) const;
    [[nodiscard]] std::optional<double> maybe_number(Key const& key, Given const& given = {}) const;
    [[nodiscard]] std::vector<double> numbers(Key const& key, Given const& given = {}) const;
    [[nodiscard]] std::vector<std::pair<double, double>> pairs(Key const& key, Given const& given = {}) const;
    [[nodiscard]] std::int64_t integer(Key const& key, GivenInteger const& given = {}) const;
    [[nodiscard]] bool boolean(Key const& key) const;
    /// \param otherwise of a key whose default is stated in words; "" where an optional one is absent
    [[nodiscard]] std::string text(Key const& key, std::string_view otherwise = {}) const;
    [[nodiscard]] std::vector<std::string> texts(Key const& key) const;
    /// \param entries the registry that the key's words are of
    template <class Value> [[nodiscard]] Value choice(Key const& key, std::span<Entry<Value> const> entries) const {
        if (!has(key.name) && key.absent.kind == Default::Kind::value) {
            keep_default(key.name, std::string(key.absent.words));
            return find_entry(entries, key.absent.words, key.name).value;
        }
        return choice(key.name, entries);
    }
    [[nodiscard]] Table child(Key const& key) const { return child(key.name); }
    [[nodiscard]] Table child_or_empty(Key const& key) const { return child_or_empty(key.name); }
    [[nodiscard]] std::vector<Table> children(Key const& key) const { return children(key.name); }
    /// @}

    [[nodiscard]] double number(std::string_view key, Dimension dimension, Range range) const;
    [[nodiscard]] double number(std::string_view key, Dimension dimension, Range range, double otherwise) const;
    [[nodiscard]] std::optional<double> maybe_number(std::string_view key, Dimension dimension, Range range) const;
    [[nodiscard]] std::vector<double> numbers(std::string_view key, Dimension dimension, Range range) const;
    /// A list of [x, y] pairs.
    [[nodiscard]] std::vector<std::pair<double, double>> pairs(std::string_view key, Dimension first,
                                                               Dimension second) const;

    /// The unit that is written at `key`, in its list or its table first; "" if none is, or the key is absent.
    [[nodiscard]] std::string unit_at(std::string_view key) const;

    /// Is a number written at `key`, in its list or its table, without a unit? A `count` in a table is none.
    [[nodiscard]] bool is_bare_at(std::string_view key) const;

    [[nodiscard]] std::int64_t integer(std::string_view key, std::int64_t low, std::int64_t high) const;
    [[nodiscard]] std::int64_t integer(std::string_view key, std::int64_t low, std::int64_t high,
                                       std::int64_t otherwise) const;
    [[nodiscard]] bool boolean(std::string_view key, bool otherwise) const;
    [[nodiscard]] std::string text(std::string_view key) const;
    [[nodiscard]] std::string text(std::string_view key, std::string_view otherwise) const;
    [[nodiscard]] std::vector<std::string> texts(std::string_view key) const;

    /// The value registered under the text at `key`; an unknown name is refused with a suggestion.
    template <class Value>
    [[nodiscard]] Value choice(std::string_view key, std::span<Entry<Value> const> entries) const {
        if (!has(key)) {
            fail_missing(key, "State one of: " + joined(names_of(entries)));
        }
        auto const name = text(key);
        try {
            return find_entry(entries, name, key).value;
        } catch (InputError const& error) {
            fail(key, error.what());
        }
    }
    template <class Value>
    [[nodiscard]] Value choice(std::string_view key, std::span<Entry<Value> const> entries, Value otherwise) const {
        if (has(key)) {
            return choice(key, entries);
        }
        if constexpr (std::equality_comparable<Value>) {
            for (auto const& entry : entries) {
                if (entry.value == otherwise) {
                    take_default_word(key, entry.name);
                }
            }
        }
        return otherwise;
    }

    [[nodiscard]] Table child(std::string_view key) const;
    /// An empty table where `key` is absent.
    [[nodiscard]] Table child_or_empty(std::string_view key) const;
    [[nodiscard]] std::vector<Table> children(std::string_view key) const;

    /// Another document, which this table names: its values are listed below this table's place.
    /// \throws InputError on a syntax error
    [[nodiscard]] Table named_document(std::string_view text, std::string file) const;

    /// All values read so far of this document and those it names, and the defaults that stood in, each with where it
    /// comes from: `{value = ..., basis = "published" | "measured" | "assumed", source = "...", range = [low, high]}`
    /// in place of a value, `basis` and `source` of a table for all of it, or a table `basis` with an entry per key.
    [[nodiscard]] std::vector<InputValue> inputs() const;

    /// Place of `key` (of this table, if it is absent).
    [[nodiscard]] Location where(std::string_view key = {}) const;
    /// Throws InputError at `key`; the message is `key: <message>`.
    [[noreturn]] void fail(std::string_view key, std::string_view message) const;
    /// Throws InputError for a key that must be there and is not, at the key that may have been meant for it.
    /// \param advice what to do, without a full stop
    [[noreturn]] void fail_missing(std::string_view key, std::string_view advice = "Add this key") const;

    /// States the keys that this table may have, before any is read: a missing one is then reported together with
    /// unknown ones.
    void may_have(std::initializer_list<std::string_view> keys) const;
    void may_have(KeyTable const& keys) const;

    /// Runs `build`, putting the place of `key` in front of any InputError it throws that names no file itself.
    template <class Build> auto located(std::string_view key, Build&& build) const {
        try {
            return build();
        } catch (InputError const& error) {
            fail(key, error.what());
        }
    }

    /// \throws InputError at the first key of this table that nothing has read.
    void finish() const;

    /// All of this table and of those in it that is not as described_by says: keys that must be there and are not, that
    /// are not known, of another type or out of range. Other faults only readers find.
    [[nodiscard]] std::vector<Fault> faults() const;

  private:
    void keep_default(std::string_view key, std::string text) const;
    void take_default_word(std::string_view key, std::string_view word) const;

    struct Node;
    class FaultFinder;
    explicit Table(std::shared_ptr<Node> node) : node_(std::move(node)) {}
    std::shared_ptr<Node> node_;
};

}  // namespace overturn::config
