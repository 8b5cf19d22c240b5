/// Who does the work of an estimator: one process or many, the answer is the same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "core/error.hpp"

namespace overturn::rare {

/// One step of an estimator: items that are independent of each other.
struct Stage {
    std::string name;  ///< of its own within an estimator's run: "pilot-2"
    std::int64_t items = 0;
    std::int64_t block = 64;    ///< items that are done, and kept, together
    std::size_t row_bytes = 0;  ///< of an item's answer
};

/// Estimators run the same on every rank and take everything that is dear, or that may differ between machines, from
/// here; so they never know who did it.
class Workforce {
  public:
    /// Fills the rows of items [first, first + rows / row_bytes).
    using Work = std::function<void(std::int64_t first, std::span<std::byte> rows)>;

    Workforce() = default;
    Workforce(Workforce const&) = delete;
    Workforce& operator=(Workforce const&) = delete;
    Workforce(Workforce&&) = delete;
    Workforce& operator=(Workforce&&) = delete;
    virtual ~Workforce() = default;

    /// All rows in the order of the items, the same on every rank. Collective.
    [[nodiscard]] virtual std::vector<std::byte> rows_of(Stage const& stage, Work const& work) = 0;

    /// Rows as structs. \param work fills the rows of the items from `first` on
    template <class Row>
    [[nodiscard]] std::vector<Row> map(Stage stage, std::function<void(std::int64_t, std::span<Row>)> const& work) {
        static_assert(std::is_trivially_copyable_v<Row>);
        stage.row_bytes = sizeof(Row);
        auto const bytes = rows_of(stage, [&](std::int64_t first, std::span<std::byte> out) {
            std::vector<Row> rows(out.size() / sizeof(Row));
            work(first, rows);
            std::memcpy(out.data(), rows.data(), out.size());
        });
        OVERTURN_ENSURE(bytes.size() == stage.items * sizeof(Row));
        std::vector<Row> rows(stage.items);
        std::memcpy(rows.data(), bytes.data(), bytes.size());
        return rows;
    }
};

/// Workforce of this process alone.
class LoneWorker : public Workforce {
  public:
    [[nodiscard]] std::vector<std::byte> rows_of(Stage const& stage, Work const& work) override;
};

}  // namespace overturn::rare
