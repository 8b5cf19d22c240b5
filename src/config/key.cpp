#include "config/key.hpp"

namespace overturn::config {

std::vector<Key const*> KeyTable::every_key() const {
    std::vector<Key const*> own;
    for (auto const& key : keys) {
        own.push_back(&key);
    }
    std::vector<Key const*> theirs;
    for (auto const* other : also) {
        if (other != nullptr) {
            auto const more = other->every_key();
            theirs.insert(theirs.end(), more.begin(), more.end());
        }
    }
    // The key that distinguishes tables of one place comes first.
    auto& every = chosen_by.empty() ? own : theirs;
    auto const& rest = chosen_by.empty() ? theirs : own;
    every.insert(every.end(), rest.begin(), rest.end());
    return every;
}

Key const* KeyTable::find(std::string_view name) const {
    for (auto const* key : every_key()) {
        if (key->name == name) {
            return key;
        }
    }
    return nullptr;
}

}  // namespace overturn::config
