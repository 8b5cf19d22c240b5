/// Trials of rare events drawn again from what a results file holds of them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/rare_problem.hpp"
#include "rare/pulse_mixture.hpp"
#include "results/rare_rows.hpp"
#include "store/results_file.hpp"

namespace overturn {

/// Replays the rows of a limit state of one body. \pre file and campaign outlive it
class RareReplayer {
  public:
    RareReplayer(store::ResultsReader const& file, CampaignSpec const& spec, std::size_t body, std::size_t limit = 0);

    [[nodiscard]] RareProblem const& problem() const { return problem_; }
    [[nodiscard]] std::int64_t rows() const { return rows_; }
    [[nodiscard]] RareRow stored(std::int64_t row) const;
    /// The row as this program draws and answers it.
    [[nodiscard]] RareRow again(RareRow const& stored, std::int64_t number) const;
    /// The columns, of those that the file has, in which the two differ in any bit.
    [[nodiscard]] std::vector<std::string> differing(RareRow const& stored, RareRow const& again) const;
    /// The factors whose bits a row holds.
    [[nodiscard]] std::vector<double> factors(RareRow const& row) const;
    /// Mixture that the row's stage was drawn from, in its replicate. \pre the row is one of a mixture
    [[nodiscard]] rare::Mixture mixture_of(RareRow const& row) const;
    /// The normals of a row of a chain, through all that it descends from.
    [[nodiscard]] std::vector<double> normals_of_chain(RareRow const& row, std::int64_t number) const;

  private:
    [[nodiscard]] std::string place(RareRow const& row) const;
    [[nodiscard]] rare::DrawKey key_of(RareRow const& row) const;
    void answer(RareRow& row, std::span<double const> normals) const;
    [[nodiscard]] RareRow again_from_mixture(RareRow row) const;
    [[nodiscard]] RareRow again_from_chain(RareRow row, std::int64_t number) const;

    store::ResultsReader const& file_;
    CampaignSpec const& spec_;
    RareProblem problem_;
    std::string group_;
    store::TableSpec table_;
    std::int64_t rows_ = 0;
};

}  // namespace overturn
