/// What an observer of a trial saw.
#pragma once

#include <algorithm>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "model/history.hpp"

namespace overturn::testing {

/// A history by key.
struct Kept {
    std::map<std::string, std::vector<double>> columns;
    [[nodiscard]] double least(std::string const& key) const { return std::ranges::min(columns.at(key)); }
};

class Keeper : public Observer {
  public:
    explicit Keeper(Kept& kept) : kept_(kept) {}
    void begin(std::span<Channel const> channels) override {
        for (auto const& channel : channels) {
            keys_.emplace_back(channel.key);
        }
    }
    void at(std::span<double const> values) override {
        for (std::size_t i = 0; i < values.size(); ++i) {
            kept_.columns[keys_[i]].push_back(values[i]);
        }
    }

  private:
    Kept& kept_;
    std::vector<std::string> keys_;
};

}  // namespace overturn::testing
