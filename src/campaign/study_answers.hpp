/// A person's answers about a study before there is a campaign, each in the units in which it was typed.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/units.hpp"

namespace overturn {

struct StudyAnswers {
    std::optional<std::string> mass, pallet_mass, pallet_height, pallet_friction, cask_diameter, cask_height;
    std::optional<std::string> centre_height, base_width, base_shape, friction, restitution, pad_strength;
    std::optional<std::string> gap, wall, edge, height;
    std::optional<std::string> spectrum, spectrum_kind, spectrum_unit, components, duration, acceptance;
    std::optional<std::string> records, record_unit, baseline;
    std::vector<std::string> record_files;  ///< in the folder `records`; empty if that is a file
    bool records_of_stations = false;       ///< each of these is joined by the other components of its station
    std::optional<std::string> count, design_basis, beyond_design, levels, hazard, beta_u;

    /// Is the spectrum a file, and no published one?
    [[nodiscard]] bool has_spectrum_file() const;
    /// Are cask and pallet stated apart?
    [[nodiscard]] bool has_pallet() const { return pallet_mass.has_value(); }
    /// Is anything round the cask stated?
    [[nodiscard]] bool has_site() const { return gap || wall || edge; }
    /// Dimension of the design basis: acceleration or velocity.
    [[nodiscard]] Dimension level_dimension() const;
};

/// The quantities of an answer such as "900 gal, 1200 gal".
[[nodiscard]] std::vector<std::string> listed_in(std::string const& answer);

/// Ends of a band, "0.3 to 0.6", as they were typed; nothing of any other answer.
[[nodiscard]] std::optional<std::pair<std::string, std::string>> band_in(std::string const& answer);

struct StudyQuestion {
    char const* option;   ///< "--mass"
    char const* example;  ///< "'117 t'"
    char const* words;    ///< the question, for help and prompt
    std::optional<std::string> StudyAnswers::*answer;
    /// \throws InputError without the option's name
    void (*check)(std::string const& answer);
    bool must = false;  ///< nothing can be assumed for it
    bool (*applies)(StudyAnswers const& answers) = [](StudyAnswers const&) { return true; };
    char const* otherwise = "";  ///< why not where it does not apply
};

/// In the order in which a person is asked: each applies by answers to those before it.
[[nodiscard]] std::span<StudyQuestion const> study_questions();

/// \throws InputError that begins with the option, for a unit, number or word that cannot be
void check_answer(StudyQuestion const& question, std::string const& answer);

/// Each answer, then what they are together. \throws InputError also for an answer whose subject is not stated
void check_answers(StudyAnswers const& answers);

/// Options without which there is no study: "--mass", "--spectrum or --records".
[[nodiscard]] std::vector<std::string> missing_answers(StudyAnswers const& answers);

}  // namespace overturn
