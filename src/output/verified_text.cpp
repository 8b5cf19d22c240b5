#include "output/verified_text.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include <fmt/ranges.h>

#include "campaign/version.hpp"
#include "output/made_by.hpp"
#include "output/record_page.hpp"
#include "results/stored_names.hpp"
#include "store/seal.hpp"

namespace overturn::output {
namespace {

std::string counted(Json const& record) {
    auto const of = [&](char const* rows) {
        return share_of(record.at(rows).get<std::int64_t>(),
                        record.at(std::string("stored_") + rows).get<std::int64_t>());
    };
    bool const has_rare = record.at("stored_rare").get<std::int64_t>() > 0;
    return fmt::format("{} trials, {} waves{}", of("trials"), of("waves"),
                       has_rare ? fmt::format(", {} rows of rare events", of("rare")) : "");
}

std::string differing(Verified const& found) {
    return fmt::format("{} trials, {} waves{} differ; first {}", found.differing_trials, found.differing_waves,
                       found.rare > 0 ? fmt::format(", {} rows of rare events", found.differing_rare) : "",
                       found.first);
}

// Columns that are in no comparison, and why.
constexpr std::array<std::pair<char const*, char const*>, 2> reasons{
    {{"unknown_columns", "this program does not know them"}, {"absent_columns", "the file does not have them"}}};

// The first of a list of the record, as many as a line holds.
std::string listed(Json const& json, char const* key) {
    constexpr std::size_t most = 12;
    auto const all = json.at(key).get<std::vector<std::string>>();
    auto const shown = std::span(all).first(std::min(most, all.size()));
    return fmt::format("{}{}", fmt::join(shown, ", "),
                       all.size() > most ? fmt::format(" and {} more", all.size() - most) : "");
}

}  // namespace

std::string share_of(std::int64_t some, std::int64_t all) {
    return some < all ? fmt::format("{} of {}", some, all) : fmt::format("{}", some);
}

Json verified_json(Verification const& of, store::ResultsReader const& file, CampaignSpec const& spec,
                   Verified const& found) {
    return {{"passed", found.all_equal()},
            {"file", of.file},
            {"content_sha256", file.text("content_sha256")},
            {"sha256", store::sealed_digest(of.file)},
            {"made_by", maker_of(file)},
            {"program", program_identity()},
            {"machine", machine()},
            {"ranks", of.ranks},
            {"date", of.date},
            {"sample", of.sample ? Json(*of.sample) : Json(nullptr)},
            {"seed", of.sample ? Json(of.seed) : Json(nullptr)},
            {"trials", found.trials},
            {"waves", found.waves},
            {"rare", found.rare},
            {"stored_trials", found.stored_trials},
            {"stored_waves", found.stored_waves},
            {"stored_rare", found.stored_rare},
            {"differing_trials", found.differing_trials},
            {"differing_waves", found.differing_waves},
            {"differing_rare", found.differing_rare},
            {"first", found.first},
            {"unknown_columns", unknown_columns(file, spec)},
            {"absent_columns", absent_columns(file, spec)}};
}

std::string verified_text(Verification const& of, Verified const& found, Json const& json) {
    if (found.all_equal()) {
        return fmt::format("{}: {} recomputed, all bit-equal to the stored rows{}\n", of.file, counted(json),
                           json.at("absent_columns").empty() ? "" : ", in the columns that the file has");
    }
    return fmt::format("{}: {} recomputed, NOT all bit-equal: {}\n", of.file, counted(json), differing(found));
}

std::vector<std::string> not_compared(Json const& json) {
    std::vector<std::string> lines;
    for (auto const& [key, why] : reasons) {
        if (auto const columns = listed(json, key); !columns.empty()) {
            lines.push_back(fmt::format("not compared ({}): {}", why, columns));
        }
    }
    return lines;
}

std::string verified_page(Json const& json) {
    auto const text = [&](char const* key) { return json.at(key).get<std::string>(); };
    auto const number = [&](char const* key) { return json.at(key).get<std::int64_t>(); };
    bool const passed = json.at("passed").get<bool>();
    RecordPage page{.title = !passed                       ? "Verification: rows DIFFER"
                             : json.at("sample").is_null() ? "Verification: all rows are bit-equal"
                                                           : "Verification: " + counted(json) + " are bit-equal",
                    .facts = {{"file", text("file")},
                              {"content_sha256", text("content_sha256")},
                              {"seal", text("sha256")},
                              {"made by", text("made_by")},
                              {"recomputed by", "overturn " + text("program")},
                              {"machine", text("machine")},
                              {"ranks", fmt::format("{}", number("ranks"))},
                              {"rows", json.at("sample").is_null() ? "all"
                                                                   : fmt::format("{} drawn at random, seed {}",
                                                                                 number("sample"), number("seed"))}},
                    .head = {"result", "rows of", "recomputed", "differ"},
                    .rows = {}};
    if (!text("date").empty()) {
        page.facts.insert(page.facts.begin(), {"date", text("date")});
    }
    if (!passed) {
        page.facts.emplace_back("first difference", text("first"));
    }
    for (auto const& [key, why] : reasons) {
        if (auto const columns = listed(json, key); !columns.empty()) {
            page.facts.emplace_back(fmt::format("not compared ({})", why), columns);
        }
    }
    for (auto const* of : {"trials", "waves", "rare"}) {
        auto const differ = number((std::string("differing_") + of).c_str());
        auto const stored = number((std::string("stored_") + of).c_str());
        if (stored > 0) {
            page.rows.push_back(
                {{differ == 0 ? "PASS" : "FAIL", of, share_of(number(of), stored), fmt::format("{}", differ)},
                 differ == 0});
        }
    }
    return html_of(page);
}

}  // namespace overturn::output
