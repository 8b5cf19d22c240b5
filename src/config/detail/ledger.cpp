#include "config/detail/ledger.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

namespace overturn::config {
namespace {

bool outranks(InputValue const& added, InputValue const& there) {
    bool const default_added = added.basis == Basis::by_default;
    bool const default_there = there.basis == Basis::by_default;
    if (default_added != default_there) {
        return default_there;
    }
    if (added.depth != there.depth) {
        return added.depth < there.depth;
    }
    // A value may be read twice, first to see which kind it is: as a number it says most.
    return added.number.has_value() || !there.number.has_value();
}

}  // namespace

void Ledger::add(InputValue value) {
    auto const [place, is_new] = places_.try_emplace(value.key, values_.size());
    if (is_new) {
        values_.push_back(std::move(value));
    } else if (auto& there = values_[place->second]; outranks(value, there)) {
        there = std::move(value);
    }
}

void Ledger::add_left_out(InputValue value) {
    if (auto const there = places_.find(value.key);
        there != places_.end() && values_[there->second].basis == Basis::by_default) {
        value.text = values_[there->second].text;
    }
    add(std::move(value));
}

bool Ledger::is_outranked(InputValue const& value) const {
    auto const by = [&](std::size_t place) {
        auto const& other = values_[place];
        return other.basis != Basis::by_default && (other.depth < value.depth || value.basis == Basis::by_default);
    };
    // bodies[0].mass and bodies[0].mass.median speak of the same value.
    for (auto dot = value.key.rfind('.'); dot != std::string::npos && dot > 0; dot = value.key.rfind('.', dot - 1)) {
        if (auto const outer = places_.find(std::string_view(value.key).substr(0, dot));
            outer != places_.end() && by(outer->second)) {
            return true;
        }
    }
    auto const within = value.key + ".";
    for (auto inner = places_.lower_bound(within); inner != places_.end() && inner->first.starts_with(within);
         ++inner) {
        if (by(inner->second)) {
            return true;
        }
    }
    return false;
}

std::vector<InputValue> Ledger::values() const {
    std::vector<InputValue> kept;
    std::ranges::copy_if(values_, std::back_inserter(kept),
                         [&](InputValue const& value) { return !is_outranked(value); });
    return kept;
}

}  // namespace overturn::config
