#include "output/workbook.hpp"

#include <cmath>
#include <string>

#include <fmt/format.h>
#if OVERTURN_XLSX
#include <xlsxwriter.h>
#endif

#include "core/error.hpp"
#include "store/durable.hpp"

namespace overturn::output {

#if OVERTURN_XLSX
namespace {

void check(lxw_error error, std::filesystem::path const& path) {
    if (error != LXW_NO_ERROR) {
        throw SystemError(
            fmt::format("cannot write {} (libxlsxwriter: {}). Free space, choose another folder with -o, "
                        "or take csv alone: --as csv",
                        path.string(), lxw_strerror(error)));
    }
}

lxw_error write_cell(lxw_worksheet* sheet, lxw_row_t row, lxw_col_t column, SheetCell const& cell) {
    constexpr std::int64_t exact = std::int64_t{1} << 53U;  // beyond it a double holds no more every integer
    auto const text = [&](std::string const& shown) {
        return worksheet_write_string(sheet, row, column, shown.c_str(), nullptr);
    };
    if (auto const* const number = std::get_if<double>(&cell)) {
        return std::isfinite(*number) ? worksheet_write_number(sheet, row, column, *number, nullptr)
                                      : text(fmt::format("{}", *number));
    }
    if (auto const* const count = std::get_if<std::int64_t>(&cell)) {
        return *count > -exact && *count < exact
                   ? worksheet_write_number(sheet, row, column, static_cast<double>(*count), nullptr)
                   : text(fmt::format("{}", *count));
    }
    auto const* const name = std::get_if<std::string_view>(&cell);
    return name == nullptr ? LXW_NO_ERROR : text(std::string(*name));
}

void write_sheet(lxw_workbook* book, Sheet const& sheet, std::filesystem::path const& path) {
    auto* const page = workbook_add_worksheet(book, sheet.name.c_str());
    check(page == nullptr ? LXW_ERROR_MEMORY_MALLOC_FAILED : LXW_NO_ERROR, path);
    worksheet_freeze_panes(page, 1, 0);
    lxw_row_t row = 0;
    for (std::size_t c = 0; c < sheet.columns.size(); ++c) {
        auto const title = sheet.columns[c].title();
        check(write_cell(page, row, static_cast<lxw_col_t>(c), std::string_view(title)), path);
    }
    sheet.each_row([&](std::span<SheetCell const> cells) {
        ++row;
        for (std::size_t c = 0; c < cells.size(); ++c) {
            check(write_cell(page, row, static_cast<lxw_col_t>(c), cells[c]), path);
        }
    });
}

}  // namespace

void require_workbook(std::span<Sheet const> sheets) {
    for (auto const& sheet : sheets) {
        validate(sheet.rows < LXW_ROW_MAX,
                 "{} {} (a sheet of Excel holds {} and its header). Write csv alone: --as csv", sheet.rows, sheet.name,
                 LXW_ROW_MAX - 1);
        validate(sheet.columns.size() <= LXW_COL_MAX,
                 "{} columns of {} (a sheet of Excel holds {}). Write csv alone: --as csv", sheet.columns.size(),
                 sheet.name, LXW_COL_MAX);
    }
}

void write_workbook(std::filesystem::path const& path, std::span<Sheet const> sheets) {
    store::FileInWork file(path);
    auto folder = path.has_parent_path() ? path.parent_path().string() : std::string(".");
    lxw_workbook_options options{.constant_memory = LXW_TRUE, .tmpdir = folder.data(), .use_zip64 = LXW_FALSE};
    auto* const book = workbook_new_opt(file.beside().c_str(), &options);
    check(book == nullptr ? LXW_ERROR_MEMORY_MALLOC_FAILED : LXW_NO_ERROR, path);
    constexpr time_t same_always = 946684800;  // the book's date: 2000-01-01, for equal bytes
    lxw_doc_properties properties{};
    properties.created = same_always;
    workbook_set_properties(book, &properties);
    try {
        for (auto const& sheet : sheets) {
            write_sheet(book, sheet, path);
        }
    } catch (...) {
        lxw_workbook_free(book);
        throw;
    }
    check(workbook_close(book), path);
    file.keep();
}
#else
void require_workbook(std::span<Sheet const> /*sheets*/) {
    throw InputError(
        "xlsx (this program was built without libxlsxwriter). Install libxlsxwriter-dev and build again, "
        "or write csv alone: --as csv");
}

void write_workbook(std::filesystem::path const& /*path*/, std::span<Sheet const> sheets) { require_workbook(sheets); }
#endif

}  // namespace overturn::output
