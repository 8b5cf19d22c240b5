/// Writing and reading the results file: columns with units and descriptions, byte-identical for identical content.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/field.hpp"
#include "store/row_places.hpp"
#include "store/seal.hpp"
#include "store/stretches.hpp"

namespace overturn::store {

inline constexpr char const* format_name = "overturn-results";
inline constexpr std::int64_t format_version = 5;
inline constexpr char const* no_text = "(none)";       ///< the name of an empty text
inline constexpr std::int64_t oldest_format_read = 3;  ///< earlier files are read by the program that made them

/// Of a packed column; one of no more rows lies as in a plain file, but layout_column.
inline constexpr std::int64_t rows_of_a_chunk = 1 << 14U;

/// In a packed file this column is in chunks however short it is: it shows how the file lies.
inline constexpr std::string_view layout_column = "trials/verdict";

/// How the columns of long tables lie in the file. Their content, and its digest, is the same.
enum class Layout {
    plain,  ///< as they are in memory
    packed  ///< deflated in chunks of rows_of_a_chunk, their bytes shuffled before: of long columns a sixth
};

/// A column is a field of rows; a group of them is appended row by row.
struct TableSpec {
    std::string group;  ///< "trials", "waves/type-a"
    std::size_t row_bytes = 0;
    Fields columns;
    /// Axis of the rows: one of the columns; else the dataset of an earlier table ("trials/trial"); else, as "trial", a
    /// further dataset of the group that numbers the rows from 0. Empty: each column is its own.
    std::string axis = {};
    std::string axis_description = {};

    /// Is the axis a dataset of its own?
    [[nodiscard]] bool numbers_rows() const;
};

/// A results file being written. It becomes `path` only in finish(), whole and durable; until then a file beside it
/// grows.
class ResultsWriter {
  public:
    /// \throws SystemError if the file cannot be made
    explicit ResultsWriter(std::filesystem::path path, Layout layout = Layout::plain);
    ~ResultsWriter();
    ResultsWriter(ResultsWriter const&) = delete;
    ResultsWriter& operator=(ResultsWriter const&) = delete;
    ResultsWriter(ResultsWriter&&) = delete;
    ResultsWriter& operator=(ResultsWriter&&) = delete;

    void attribute(std::string const& name, std::string const& text);
    void attribute(std::string const& name, std::int64_t value);
    void attribute(std::string const& where, std::string const& name, std::string const& text);
    void attribute(std::string const& where, std::string const& name, std::int64_t value);
    void attribute(std::string const& where, std::string const& name, double value);
    /// Names of all groups so far.
    [[nodiscard]] std::vector<std::string> groups() const;

    /// Declares a table of exactly `rows` rows. \return its number for append
    std::size_t table(TableSpec spec, std::int64_t rows);
    /// Appends rows, given as the bytes of consecutive row structs.
    void append(std::size_t number, std::span<std::byte const> rows);

    /// A small array at once. Its axis is the earlier one of the group `where` that `scale` names, else itself.
    /// Integers may have names of values; of the type category they are stored as an enumeration.
    void array(std::string const& where, Field const& spec, std::vector<double> const& values,
               std::string const& scale = {});
    void array(std::string const& where, Field const& spec, std::vector<std::int64_t> const& values,
               std::string const& scale = {});
    /// The bytes of an input file, compressed.
    void bytes(std::string const& where, std::string const& name, std::string const& description,
               std::string const& content);

    /// Where the rows of the tables so far lie in the growing file. Whoever fetches them has them written, all of them,
    /// by PlacedRows and no row by append(). \pre layout plain, and no row was appended
    [[nodiscard]] RowPlaces give_places();

    /// Adds the digest of every object, closes the file, seals it, makes it durable and gives it its name.
    /// \param hash of the rows, and of the whole file
    void finish(HashStretches const& hash = hash_stretches);

  private:
    struct Growing;
    void settle();
    struct ReadBack {
        std::map<std::string, Stretches> long_columns;  ///< by path
        Stretches between;                              ///< columns
        StretchDigests digests;                         ///< of both, and of stretches of the file
    };
    [[nodiscard]] RowPlaces places() const;
    [[nodiscard]] ReadBack read_back(HashStretches const& hash) const;
    void add_digests(ReadBack const& read);

    std::filesystem::path path_;
    std::filesystem::path growing_path_;
    std::unique_ptr<Growing> growing_;
    bool settled_ = false;
    bool finished_ = false;
};

/// Description of a column, as its file gives it.
struct ColumnMeaning {
    std::string path;  ///< "trials/v_wes"
    std::string units, description;
    FieldType type =
        FieldType::real;    ///< of numbers; category: an enumeration; integers may have names too (categories())
    std::int64_t rows = 0;  ///< -1: it holds texts, or does not run along one axis
};

/// Check of a file against its seal.
enum class Trust {
    sealed,     ///< every byte must be as it was written
    unverified  ///< whatever it says: for those who edit on purpose, and who have just written it
};

/// A finished results file, read only. Names in messages are those of the file.
class ResultsReader {
  public:
    /// \throws InputError if it is missing, not of this format, of another version of it, not as it was written (what
    /// changed is named), or not all inside the file
    explicit ResultsReader(std::filesystem::path const& path, Trust trust = Trust::sealed,
                           std::string_view format = format_name);
    ~ResultsReader();
    ResultsReader(ResultsReader const&) = delete;
    ResultsReader& operator=(ResultsReader const&) = delete;
    ResultsReader(ResultsReader&&) = delete;
    ResultsReader& operator=(ResultsReader&&) = delete;

    /// Was it checked against its seal when it was opened?
    [[nodiscard]] bool is_sealed() const { return trust_ == Trust::sealed; }
    /// Is it as it was written? Reads all of it if it was opened unchecked.
    [[nodiscard]] bool is_as_written() const;

    [[nodiscard]] std::string text(std::string const& name) const;
    [[nodiscard]] std::int64_t integer(std::string const& name) const;
    [[nodiscard]] bool has(std::string const& dataset) const;
    /// \throws InputError if it is not there
    void require(std::string const& dataset) const;
    /// Rows of a column of numbers. \throws InputError if it is none
    [[nodiscard]] std::int64_t length(std::string const& dataset) const;
    /// Of the columns of trials, as layout_column shows it; none where that is plain and they are too short to differ.
    [[nodiscard]] std::optional<Layout> layout() const;
    [[nodiscard]] std::vector<std::string> members(std::string const& group) const;
    /// All columns and small arrays, by path.
    [[nodiscard]] std::vector<ColumnMeaning> columns() const;
    [[nodiscard]] std::vector<double> reals(std::string const& dataset) const;
    [[nodiscard]] std::vector<std::int64_t> integers(std::string const& dataset) const;
    /// A column of texts: names of numbers, or lines of an attribute of its group.
    [[nodiscard]] std::vector<std::string> texts(std::string const& dataset) const;
    /// The names that a column of categories may hold, or an integer whose attribute flag_meanings names its values,
    /// with the file's own numbers. Empty: it is none, or not there.
    [[nodiscard]] std::vector<Category> categories(std::string const& dataset) const;
    /// A column of categories as the numbers that `names` gives to their names; unknown_category where it names none.
    [[nodiscard]] std::vector<std::int64_t> named(std::string const& dataset, std::span<Category const> names) const;
    /// Rows of a table from `first` on, as the bytes of consecutive row structs that ResultsWriter::append took. A
    /// column that the file does not have is unknown: NaN, or the field's `absent`. Categories are those of the same
    /// name, whatever number the file gives them. \throws InputError if a column has other than `length` rows, a
    /// category without a name, or an essential one is missing or unknown
    void rows(TableSpec const& spec, std::int64_t length, std::int64_t first, std::span<std::byte> rows) const;
    /// One element.
    [[nodiscard]] double real_at(std::string const& dataset, std::int64_t row) const;
    [[nodiscard]] std::int64_t integer_at(std::string const& dataset, std::int64_t row) const;
    [[nodiscard]] std::string content(std::string const& dataset) const;
    /// A text attribute of a dataset or group.
    [[nodiscard]] std::string text_attribute(std::string const& object, std::string const& name) const;
    /// The same, or `other` where there is none.
    [[nodiscard]] std::string attribute_or(std::string const& object, std::string const& name,
                                           std::string const& other) const;

  private:
    struct Opened;
    [[nodiscard]] std::string text_or(std::string const& name) const;
    void open(std::string_view format);
    [[noreturn]] void refuse(Seal seal, std::string_view format);
    [[nodiscard]] std::string what_changed() const;
    [[nodiscard]] std::string digest_faults() const;

    std::filesystem::path path_;
    Trust trust_;
    std::unique_ptr<Opened> opened_;
};

/// "1.10.8"
[[nodiscard]] std::string hdf5_version();

}  // namespace overturn::store
