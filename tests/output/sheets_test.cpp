// Requirement R-917: cells of csv are quoted where they must be and read back to the bit; what no sheet of Excel holds
// is refused before any work.
#include "output/sheets.hpp"

#include <limits>

#include "output/csv.hpp"
#include "output/workbook.hpp"
#include "support/expect_input_error.hpp"
#include "support/temporary_folder.hpp"

namespace overturn::output {
namespace {

using testing::expect_input_error;
using testing::slurp;
using testing::TemporaryFolder;

Sheet sheet_of(std::vector<SheetCell> cells) {
    Sheet sheet{.name = "trials", .rows = 1};
    sheet.columns.resize(cells.size(), SheetColumn{"peak_slip", "m", ""});
    sheet.each_row = [cells = std::move(cells)](Sheet::Take const& take) { take(cells); };
    return sheet;
}

TEST(Sheets, CellsAreAsRfc4180HasThem) {
    TemporaryFolder const folder;
    std::string const hostile = "a,\"b\"\r\n=1+1";
    auto const sheet = sheet_of({SheetCell(), 0.1 + 0.2, std::int64_t{-7}, std::string_view(hostile),
                                 std::numeric_limits<double>::infinity(), 5e-324, std::string_view("type-a")});

    write_csv(folder / "t.csv", sheet);

    auto const text = slurp(folder / "t.csv");
    EXPECT_EQ(text.substr(text.find('\n') + 1), ",0.30000000000000004,-7,\"a,\"\"b\"\"\r\n=1+1\",inf,5e-324,type-a\n");
    EXPECT_TRUE(text.starts_with("peak_slip [m],peak_slip [m],"));
}

TEST(Sheets, WhatNoSheetOfExcelHoldsIsRefused) {
    constexpr std::int64_t rows_of_excel = 1'048'576;
    constexpr std::size_t columns_of_excel = 16'384;
    auto sheet = sheet_of({0.0});
    std::vector<Sheet> const built_with{sheet};
    try {
        require_workbook(built_with);
    } catch (InputError const& error) {
        EXPECT_NE(std::string(error.what()).find("without libxlsxwriter"), std::string::npos);
        GTEST_SKIP() << "no libxlsxwriter in this build (install libxlsxwriter-dev)";
    }
    sheet.rows = rows_of_excel - 1;  // and a header
    EXPECT_NO_THROW(require_workbook(std::span(&sheet, 1)));
    sheet.rows = rows_of_excel;
    expect_input_error([&] { require_workbook(std::span(&sheet, 1)); }, "1048576 trials", "--as csv");
    auto const wide = sheet_of(std::vector<SheetCell>(columns_of_excel + 1, 0.0));
    expect_input_error([&] { require_workbook(std::span(&wide, 1)); }, "16385 columns of trials", "--as csv");
}

}  // namespace
}  // namespace overturn::output
