#include "campaign/withdrawn_keys.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "campaign/detail/campaign_keys.hpp"
#include "config/table.hpp"

namespace overturn {
namespace {

// Of [accuracy].
constexpr std::array withdrawn{accuracy_keys["taylor_order"], accuracy_keys["substeps"],
                               accuracy_keys["step_tolerance"], accuracy_keys["settle"]};

bool is_withdrawn(config::Key const& key) {
    bool const of_accuracy = std::ranges::any_of(accuracy_keys.all, [&](auto const& own) { return &own == &key; });
    return of_accuracy && std::ranges::find(withdrawn, key.name, &config::Key::name) != withdrawn.end();
}

double constant_of(config::Key const& key) {
    return key.absent.integer ? static_cast<double>(*key.absent.integer) : key.absent.number.value_or(0);
}

}  // namespace

std::vector<config::Key const*> listed_keys(config::KeyTable const& table) {
    auto keys = table.every_key();
    std::erase_if(keys, [](config::Key const* key) { return is_withdrawn(*key); });
    return keys;
}

void refuse_withdrawn_keys(CampaignInput const& input) {
    auto const table = config::Table::parse(input.text, input.name, input.settings).child_or_empty("accuracy");
    for (auto const& key : withdrawn) {
        if (table.has(key.name) && table.number(key.name, Dimension::none, config::Range::any()) != constant_of(key)) {
            table.fail(key.name,
                       fmt::format("not {:g} (it is a constant of all campaigns, other values of which change "
                                   "next to nothing). Leave it out",
                                   constant_of(key)));
        }
    }
}

}  // namespace overturn
