#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include "campaign/rows.hpp"
#include "cli/verbs.hpp"
#include "core/error.hpp"
#include "core/print_note.hpp"
#include "output/csv.hpp"
#include "output/sheets.hpp"
#include "output/workbook.hpp"
#include "store/durable.hpp"
#include "store/format_versions.hpp"

namespace overturn::cli {
namespace {

namespace fs = std::filesystem;

struct ExportOptions {
    std::string file;
    std::optional<std::string> folder, kind;
    bool force = false;
    Unverified unverified;

    [[nodiscard]] bool writes(char const* what) const { return !kind || *kind == what; }
    [[nodiscard]] fs::path place() const {
        return folder ? fs::path(*folder) : fs::path(file).replace_extension(".tables");
    }
};

void check(ExportOptions const& options) {
    validate(options.writes("csv") || options.writes("xlsx"),
             "--as '{}' (unknown). Say csv or xlsx, or leave it out: both", options.kind.value_or(""));
    validate(!options.place().empty(), "-o '' (no name: an unset variable?). Name a folder");
}

// The folder, if it can be one and nothing in it would be lost.
void make_place(fs::path const& folder, std::vector<fs::path> const& files, bool force) {
    std::error_code error;
    fs::create_directories(folder, error);
    validate(fs::is_directory(folder), "-o {} (is no folder and cannot be one{}). Name another", folder.string(),
             error ? ": " + error.message() : std::string());
    for (auto const& file : files) {
        validate(force || !fs::exists(file),
                 "{}: exists already (it would be lost). Name another folder with -o, or use --force", file.string());
        validate(!fs::is_directory(file), "{}: a folder (a file shall have this name). Name another folder with -o",
                 file.string());
        store::require_writable(file);
    }
}

// What `about.csv` of an earlier export says that it is of; empty if there is none.
std::string exported_from(fs::path const& about) {
    std::ifstream file(about);
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("content_sha256,")) {
            line.erase(0, line.find(',') + 1);
            return line.substr(0, line.find_first_of("\r,"));
        }
    }
    return {};
}

// Tables that are there and stay beside those that are written must be of the same results.
void refuse_mixture(fs::path const& folder, std::vector<std::string> const& all, std::vector<fs::path> const& written,
                    std::string const& content) {
    if (exported_from(folder / "about.csv") == content) {
        return;
    }
    for (auto const& name : all) {
        bool const stays = std::ranges::find(written, folder / name) == written.end() && fs::exists(folder / name);
        validate(!stays,
                 "{}: stays beside these tables (and may be of other results). Name another folder with -o, or remove "
                 "it",
                 (folder / name).string());
    }
}

// Without them a table would lose its rows.
void require_essential_columns(store::ResultsReader const& file) {
    for (auto const& field : fields_of<TrialRow>()) {
        if (field.essential) {
            file.require("trials/" + field.name);
        }
    }
}

int write_tables(ExportOptions const& options) {
    check(options);
    store::ResultsReader const file(options.file, options.unverified.trust());
    require_essential_columns(file);
    auto const sheets = output::sheets_of(file);
    (void)options.unverified.warn_if_edited(file, options.file);
    auto const folder = options.place();
    auto const book = folder / "tables.xlsx";
    std::vector<fs::path> files;
    std::vector<std::string> names{book.filename().string()};
    for (auto const& sheet : sheets) {
        names.push_back(sheet.name + ".csv");
        if (options.writes("csv")) {
            files.push_back(folder / (sheet.name + ".csv"));
        }
    }
    if (options.writes("xlsx")) {
        output::require_workbook(sheets);
        files.push_back(book);
    }
    refuse_mixture(folder, names, files, file.text("content_sha256"));
    make_place(folder, files, options.force);
    for (std::size_t i = 0; i < sheets.size() && options.writes("csv"); ++i) {
        output::write_csv(files[i], sheets[i]);
    }
    if (options.writes("xlsx")) {
        output::write_workbook(book, sheets);
    }
    if (auto const known = store::known_errors_of(file.integer("format_version")); !known.empty()) {
        print_note("{}\n", known.substr(1));
    }
    print_note("{} trials, {} waves, {} stripes, {} curves: {}\n", sheets[0].rows, sheets[1].rows, sheets[2].rows,
               sheets[3].rows, folder.string());
    return done;
}

}  // namespace

void add_export(CommandLine& line) {
    auto verb = line.verb("export", "write trials, waves, stripes and curves as csv and for Excel");
    auto options = std::make_shared<ExportOptions>();
    verb.needs("file", options->file, "results file");
    verb.takes("-o,--output", options->folder, "folder for the tables; default: FILE.tables beside the file", "FOLDER");
    verb.takes("--as", options->kind, "write csv (all digits) or xlsx (16 digits) only; default: both", "csv|xlsx");
    verb.takes("--force", options->force, "overwrite existing files");
    options->unverified.offered_by(verb);
    verb.does([options] { return write_tables(*options); });
}

}  // namespace overturn::cli
