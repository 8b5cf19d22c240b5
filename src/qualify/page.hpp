/// Results of a qualification, as text, JSON and a page.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "qualify/check.hpp"

namespace overturn::qualify {

/// The checks, and the installation that they ran on.
struct Qualification {
    Checks checks;
    std::vector<LeftOut> left_out = {};
    std::string program, machine, compiler, libraries, mpi, folder;
    int ranks = 1;
    std::string date = {};   ///< as the user states it; empty: none
    bool published = false;  ///< compared with published results

    [[nodiscard]] bool passed() const;
};

/// One line per check, then what is left out, then the sum of them with all that differ from their source.
[[nodiscard]] std::string text_of(Qualification const& shown);
[[nodiscard]] nlohmann::ordered_json json_of(Qualification const& shown);
/// One page of HTML that needs no network.
[[nodiscard]] std::string page_of(Qualification const& shown);

}  // namespace overturn::qualify
