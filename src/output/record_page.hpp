/// The page of a check that is filed: what was checked, when and where, and what was found.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace overturn::output {

struct RecordPage {
    struct Row {
        std::vector<std::string> cells;  ///< as many as `head`
        bool passed = true;
    };
    std::string title;                                       ///< "Qualification: all 36 checks pass"
    std::vector<std::pair<std::string, std::string>> facts;  ///< names and values, in this order
    std::vector<std::string> head;
    std::vector<Row> rows;
};

/// One page of HTML that needs no network. All texts are plain: what HTML would read in them is escaped.
[[nodiscard]] std::string html_of(RecordPage const& page);

}  // namespace overturn::output
