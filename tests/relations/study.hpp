/// Campaigns by their numbers, which relations change, and the rows that come of them.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/field.hpp"
#include "core/units.hpp"
#include "response/model_selector.hpp"
#include "support/campaign_rows.hpp"
#include "support/campaigns.hpp"

namespace overturn::testing {

/// Along x, y and z; empty: it does not shake that way [gal].
struct Motion {
    std::array<std::vector<double>, 3> gal{};
};

struct Solid {
    std::string name = "a";
    double mass_kg = 0, width_m = 0, centre_height_m = 0, gravity_mps2 = g0;
    std::optional<double> restitution = {};
    std::optional<std::array<double, 2>> friction = {};  ///< static, kinetic
    int axes = 3;
    std::string base = {};                              ///< but for its corners: "shape='square', bedding='flat'"
    std::vector<std::array<double, 2>> corners_m = {};  ///< of a polygon
    double pad_hz = 0;                                  ///< 0: no pad is stated
    double strength_pa = 0;                             ///< 0: it stays elastic
    bool matched = true;

    [[nodiscard]] std::string text() const;
};

/// A campaign. Numbers are written with all their digits.
struct Study {
    std::vector<Motion> motions;
    double step_s = 1.0 / 128;
    std::vector<Solid> solids;
    std::vector<double> factors;
    std::string effects = {};            ///< of `include`; empty: auto
    double least_move_m = 0.0009765625;  ///< from which on a trial that stands has slid or rocked
    double contact_step = 0.3;
    // How it is written, which changes nothing.
    bool in_gal = true;  ///< else in m/s2
    std::string_view wave_name = "w";

    [[nodiscard]] std::string text() const;
    [[nodiscard]] std::map<std::string, std::string> files() const;
};

/// Rows of trials, every column of every model: wave by wave, body by body, level by level.
struct Rows {
    std::vector<std::string> names, units;
    std::vector<std::vector<double>> rows;

    [[nodiscard]] std::optional<std::size_t> column(std::string_view name) const;
    [[nodiscard]] double at(std::size_t row, std::string_view name) const { return rows[row][*column(name)]; }
};

inline std::string Solid::text() const {
    auto text = fmt::format(
        "[[bodies]]\nname='{}'\nmass={}\nbase_width={}\ncentre_height={}\ninertia='uniform-block'\ngravity={}\n"
        "axes={}\n",
        name, mass_kg, width_m, centre_height_m, gravity_mps2, axes);
    if (restitution) {
        text += fmt::format("restitution={}\n", *restitution);
    }
    if (friction) {
        text += fmt::format("friction={{static={}, kinetic={}}}\n", (*friction)[0], (*friction)[1]);
    }
    if (!base.empty()) {
        std::vector<std::string> corners;
        for (auto const& [x, y] : corners_m) {
            corners.push_back(fmt::format("[{}, {}]", x, y));
        }
        text += corners.empty() ? fmt::format("base={{{}}}\n", base)
                                : fmt::format("base={{{}, corners=[{}]}}\n", base, fmt::join(corners, ", "));
    }
    if (pad_hz > 0) {
        text += fmt::format("pad={{vertical_frequency={}{}{}}}\n", pad_hz,
                            strength_pa > 0 ? fmt::format(", strength={}", strength_pa) : std::string(),
                            matched ? "" : ", match_restitution=false");
    }
    return text;
}

inline std::string Study::text() const {
    std::string text = "[waves]\nsource='records'\n";
    for (std::size_t i = 0; i < motions.size(); ++i) {
        text +=
            fmt::format("[[waves.records]]\nhorizontal='{}{}.csv'\nunit='{}'\n", wave_name, i, in_gal ? "gal" : "m/s2");
    }
    for (auto const& solid : solids) {
        text += solid.text();
    }
    text += fmt::format("[levels]\nmeasure='factor'\nvalues=[{}]\n", fmt::join(factors, ", "));
    text += fmt::format("[measures]\nwave_quality=false\nslid_from={0}\nrocked_from={0}\n", least_move_m);
    text += fmt::format("[accuracy]\ncontact_step={}\n", contact_step);
    return text + (effects.empty() ? std::string() : fmt::format("[effects]\ninclude=[{}]\n", effects));
}

inline std::map<std::string, std::string> Study::files() const {
    std::map<std::string, std::string> files;
    for (std::size_t i = 0; i < motions.size(); ++i) {
        auto const& gal = motions[i].gal;
        std::string text = "time [s],a_horizontal";
        text += gal[1].empty() ? "" : ",a_transverse";
        text += gal[2].empty() ? "" : ",a_vertical";
        for (std::size_t n = 0; n < gal[0].size(); ++n) {
            text += fmt::format("\n{}", static_cast<double>(n) * step_s);
            for (auto const& wave : gal) {
                if (!wave.empty()) {
                    text += fmt::format(",{}", in_gal ? wave[n] : wave[n] * 1e-2);
                }
            }
        }
        files.emplace(fmt::format("{}{}.csv", wave_name, i), text + "\n");
    }
    return files;
}

inline std::optional<std::size_t> Rows::column(std::string_view name) const {
    for (std::size_t c = 0; c < names.size(); ++c) {
        if (names[c] == name) {
            return c;
        }
    }
    return {};
}

inline double number_at(std::span<std::byte const> row, Field const& field) {
    return field.type == FieldType::real ? real_at(row, field) : static_cast<double>(integer_at(row, field));
}

inline Rows run_text(std::string const& text, std::map<std::string, std::string> const& files) {
    auto const spec = campaign_from(text, files);
    auto const trials = rows_of(spec).trials;
    ModelSelector const selector(spec.effects, spec.accuracy);
    Rows all;
    auto const name = [&](Fields const& fields, std::string const& before) {
        for (auto const& field : fields) {
            all.names.push_back(before + field.name);
            all.units.push_back(field.units);
        }
    };
    name(fields_of<TrialRow>(), "");
    for (auto const& part : selector.extra_parts()) {
        name(part.traits->fields, std::string(part.traits->name) + ".");
    }
    for (std::size_t i = 0; i < trials.rows.size(); ++i) {
        auto& row = all.rows.emplace_back();
        for (auto const& field : fields_of<TrialRow>()) {
            row.push_back(number_at(bytes_of(trials.rows[i]), field));
        }
        auto const own = std::span(trials.extra).subspan(i * selector.extra_bytes(), selector.extra_bytes());
        for (auto const& part : selector.extra_parts()) {
            for (auto const& field : part.traits->fields) {
                row.push_back(number_at(own.subspan(part.offset), field));
            }
        }
    }
    return all;
}

inline Rows run(Study const& study) { return run_text(study.text(), study.files()); }

}  // namespace overturn::testing
