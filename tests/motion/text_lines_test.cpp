// Requirement R-107: line ends, marks and Fortran's habits change no number; line numbers stay those of the file.
#include "motion/text_lines.hpp"

#include "support/expect_input_error.hpp"

namespace overturn {
namespace {

using testing::expect_input_error;

std::vector<std::string> lines_of(std::string_view content) {
    TextLines lines(content);
    std::vector<std::string> all;
    while (auto const line = lines.next()) {
        all.emplace_back(*line);
        EXPECT_EQ(lines.number(), static_cast<int>(all.size()));
    }
    return all;
}

std::vector<double> numbers_of(std::string_view line) {
    std::vector<double> values;
    append_numbers(line, "x", 1, values);
    return values;
}

TEST(TextLines, EveryLineEndGivesTheSameLines) {
    std::vector<std::string> const expected{"a", "", "b c", "d"};
    EXPECT_EQ(lines_of("a\n\nb c\nd"), expected);
    EXPECT_EQ(lines_of("a\n\nb c\nd\n"), expected);
    EXPECT_EQ(lines_of("a\r\n\r\nb c\r\nd\r\n"), expected);
    EXPECT_EQ(lines_of("a\r\r\n\r\r\nb c\r\r\nd\r\r\n"), expected);
    EXPECT_EQ(lines_of("a\r\rb c\rd\r"), expected);
}

// a user's own letters are shown as they are; bytes that are no letters, and those that a terminal acts upon,
// not.
TEST(TextLines, QuotedTextIsTheUsersOwn) {
    std::string const japanese = "\xE5\x8D\x97\xE5\x8C\x97(gal)";
    EXPECT_EQ(in_quotes(japanese), "'" + japanese + "'");
    EXPECT_EQ(in_quotes("\xC4\xB0vme \xF0\x9F\x8C\x8D"), "'\xC4\xB0vme \xF0\x9F\x8C\x8D'");
    EXPECT_EQ(in_quotes("a\tb\x1b[31m\x7f"), "'a?b?[31m?'");
    EXPECT_EQ(in_quotes("\xE9t\xE9 \xC3"), "'?t? ?'");
    EXPECT_EQ(in_quotes("\xC0\xAF \xED\xA0\x80 \xF8\x88\x80\x80\x80"),
              "'?"
              "? ?"
              "?"
              "? ?"
              "?"
              "?"
              "?"
              "?'");
    EXPECT_EQ(in_quotes("\xE2\x80\xAE \xC2\x9B \xEF\xBB\xBF"),
              "'?"
              "?"
              "? ?"
              "? ?"
              "?"
              "?'");
    std::string letters;
    for (int i = 0; i < 31; ++i) {
        letters += "\xC3\xA9";
    }
    EXPECT_EQ(in_quotes(letters), "'" + letters.substr(0, 60) + "...'");
    EXPECT_EQ(in_quotes(letters.substr(0, 60)), "'" + letters.substr(0, 60) + "'");
    EXPECT_EQ(in_quotes(""), "''");
}

TEST(TextLines, ByteOrderMarkAndControlZAreNoText) {
    EXPECT_EQ(lines_of("\xEF\xBB\xBFt,acc\n1\n\x1a\x1a\x1a"), (std::vector<std::string>{"t,acc", "1"}));
    EXPECT_TRUE(lines_of("").empty());
    EXPECT_TRUE(lines_of("\xEF\xBB\xBF").empty());
}

TEST(Numbers, GluedBySign) {
    EXPECT_EQ(numbers_of(" 1.2456000E-06-5.9452000E-06+3.5-.5"), (std::vector{1.2456e-6, -5.9452e-6, 3.5, -0.5}));
    EXPECT_EQ(numbers_of("0.5-100.25"), (std::vector{0.5, -100.25}));
}

TEST(Numbers, FortranExponents) {
    EXPECT_EQ(numbers_of("1.5D-03 -.8E+1 +2.d2\t.25E-3"), (std::vector{1.5e-3, -8.0, 200.0, 0.25e-3}));
    EXPECT_EQ(numbers_of(".1234567-103 1.5E-100 2.5E5"), (std::vector{0.1234567e-103, 1.5e-100, 2.5e5}));
    EXPECT_EQ(numbers_of("1.5-103-2.5-103"), (std::vector{1.5e-103, -2.5e-103}));
}

TEST(Numbers, AnythingElseIsRefusedWithItsLine) {
    for (char const* line : {"nan", "1 inf", "-Infinity", "*******", "1.2.3", "1e", "1.5E-061.5", "1,5", "--1", "-",
                             ".", "0x10", "1E999", "\xB0"}) {
        std::vector<double> values;
        expect_input_error([&] { append_numbers(line, "a.at2", 7, values); }, "a.at2:7: ", "not a finite number");
    }
}

}  // namespace
}  // namespace overturn
