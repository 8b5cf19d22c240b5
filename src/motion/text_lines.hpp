/// The lines and numbers of a record file, whatever system and Fortran compiler wrote it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace overturn {

/// Hands out the lines of a text one by one, without their ends. A line ends at LF, CR LF, CR CR LF (a text-mode
/// transfer of a CR LF file) or a lone CR; a UTF-8 byte order mark is skipped and a control-Z ends the text.
class TextLines {
  public:
    explicit TextLines(std::string_view content);

    /// The next line, or nothing after the last.
    [[nodiscard]] std::optional<std::string_view> next();

    /// Number of the line handed out last, counted from 1; 0 before the first.
    [[nodiscard]] int number() const { return number_; }

  private:
    std::string_view rest_;
    int number_ = 0;
};

/// Appends every number of a fixed-format line. Numbers are parted by blanks or merely by the sign of the next one
/// (1.2456E-06-5.9452E-06); Fortran D exponents and three-digit exponents that have lost their letter (.12-103) are
/// read. \throws InputError naming `file` and `line_number` at anything that is not a finite number.
void append_numbers(std::string_view line, std::string const& file, int line_number, std::vector<double>& values);

/// A Fortran edit descriptor such as (8F10.3), (1E15.6), (10I8).
struct FixedFormat {
    std::size_t per_line = 0;
    std::size_t width = 0;
};

/// The first such descriptor in `text`; nothing if there is none.
[[nodiscard]] std::optional<FixedFormat> fixed_format_in(std::string_view text);

/// Appends `count` numbers in fields of fixed width, which may touch each other. A blank field is no number.
/// \throws InputError naming `file` and the line at what is no finite number, or if the text ends before.
void append_fixed(TextLines& lines, FixedFormat format, std::size_t count, std::string const& file,
                  std::vector<double>& values);

/// Parts between any of these characters, without empty ones. The parts are views of `text`.
[[nodiscard]] std::vector<std::string_view> parted_at(std::string_view text, std::string_view separators);

/// In lower case (ASCII letters only).
[[nodiscard]] std::string lowered(std::string_view text);

/// A piece of a file in quotes for a one-line message: cut short, unprintable bytes as '?'.
[[nodiscard]] std::string in_quotes(std::string_view text);

}  // namespace overturn
