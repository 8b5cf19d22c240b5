#include "cli/report_checks.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/regular_file.hpp"
#include "output/made_by.hpp"
#include "output/summary_tables.hpp"
#include "results/hand_check.hpp"
#include "store/seal.hpp"

namespace overturn::cli {
namespace {

using output::RecordKind;

constexpr std::array kinds{RecordKind::verify, RecordKind::qualify, RecordKind::published, RecordKind::cost,
                           RecordKind::sensitivity};

CheckRecord read_record(std::string const& name) {
    auto const text = read_regular_file(name, fmt::format("--record {}", name));
    CheckRecord record{.name = name, .content = Json::parse(text, nullptr, false)};
    record.kind = output::kind_of_record(record.content, name);
    return record;
}

std::string edited_text(CheckRecord const& record) {
    return fmt::format("--record {} (not as this program writes it: edited?). Write it anew", record.name);
}

output::CheckRow row_of(CheckRecord const& record, std::string const& maker) {
    try {
        return output::check_row(record.kind, record.content, maker);
    } catch (Json::exception const&) {
        throw InputError(edited_text(record));
    }
}

void require_of_file(CheckRecord const& record, std::string const& path, store::ResultsReader const& file) {
    auto const holds = [&](char const* name, std::string const& digest) {
        auto const found = record.content.find(name);
        return found != record.content.end() && *found == digest;
    };
    validate(
        record.kind != RecordKind::verify || holds("sha256", store::sealed_digest(path)),
        "--record {} (verify wrote it of another results file than {}). Verify this one: overturn verify {} --json",
        record.name, path, path);
    bool const of_campaign = record.kind == RecordKind::cost || record.kind == RecordKind::sensitivity;
    validate(
        !of_campaign || holds("campaign_sha256", file.text("input_sha256")),
        "--record {} (cost wrote it of another campaign than {} is of). Study this one: overturn cost CAMPAIGN.toml "
        "--json",
        record.name, path);
}

}  // namespace

std::vector<CheckRecord> read_check_records(std::span<std::string const> files) {
    std::vector<CheckRecord> records;
    for (auto const& file : files) {
        auto record = read_record(file);
        auto const same = std::ranges::find(records, record.kind, &CheckRecord::kind);
        validate(same == records.end(), "--record {} beside {} (two records of one check). Leave one out", file,
                 same == records.end() ? "" : same->name);
        records.push_back(std::move(record));
    }
    return records;
}

void add_checks(std::span<CheckRecord const> records, std::string const& path, store::ResultsReader const& file,
                Json& data) {
    auto const maker = output::maker_of(file);
    std::vector<output::CheckRow> rows;
    data["sensitivity"] = nullptr;
    for (auto const kind : kinds) {
        auto const record = std::ranges::find(records, kind, &CheckRecord::kind);
        bool const there = record != records.end();
        if (there) {
            require_of_file(*record, path, file);
        }
        rows.push_back(there ? row_of(*record, maker)
                             : output::missing_check(kind, std::filesystem::path(path).filename().string()));
        if (there && kind == RecordKind::sensitivity) {
            data["sensitivity"] = record->content;
        }
    }
    data["checks"] = output::json_of(output::check_table(rows));
}

std::optional<output::NumericalError> numerical_error_of(std::span<CheckRecord const> records) {
    auto const record = std::ranges::find(records, RecordKind::cost, &CheckRecord::kind);
    if (record == records.end()) {
        return std::nullopt;
    }
    try {
        auto const& study = record->content.at("study").at(0);
        return study.at("probability").is_null()
                   ? std::nullopt
                   : std::optional(output::NumericalError{.error = study.at("numerical").get<double>(),
                                                          .is_bound = study.at("numerical_is_bound").get<bool>(),
                                                          .trials = study.at("trials").get<std::int64_t>()});
    } catch (Json::exception const&) {
        throw InputError(edited_text(*record));
    }
}

void add_hand_checks(CampaignSpec const& spec, Statistics const& statistics, std::span<BodyAnalysis const> analysis,
                     Json& data) {
    std::vector<HandCheck> checks;
    try {
        checks = hand_checks(spec);
        compare(checks, statistics, analysis);
    } catch (InputError const&) {
        checks.clear();  // a wave that cannot be made is a failed row, and counted as such
    }
    data["hand_check_lines"] = Json::array();
    for (auto const& line : output::hand_check_lines(spec, checks)) {
        data["hand_check_lines"].push_back((data["hand_check_lines"].empty() ? "By hand: " : "") + line + ".");
    }
    data["fit"].update(output::json_of(std::vector{output::hand_check_table(spec, checks)}));
}

}  // namespace overturn::cli
