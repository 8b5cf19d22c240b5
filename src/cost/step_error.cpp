#include "cost/step_error.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "cost/bench.hpp"
#include "cost/knob.hpp"

namespace overturn::cost {
namespace {

// Every sample nearer to zero by its last bit, so that what bounds the motion still bounds it.
PreparedWave nudged(PreparedWave wave) {
    for (auto* component : {&wave.motion.horizontal_mps2, &wave.motion.transverse_mps2, &wave.motion.vertical_mps2}) {
        for (double& a : *component) {
            a = std::nextafter(a, 0.0);
        }
    }
    return wave;
}

std::vector<std::string> half_steps(Accuracy const& accuracy) {
    return {fmt::format("accuracy.substeps={}", 2 * accuracy.rocking.substeps),
            fmt::format("accuracy.contact_step={}", accuracy.contact.step_ratio / 2)};
}

/// Reads a quantity off trials, whichever model answered them.
class Reader {
  public:
    Reader(CampaignSpec const& spec, LimitQuantity const& quantity) : selector_(spec.effects, spec.accuracy) {
        if (quantity.of_every_model) {
            column_ = &field_named(fields_of<TrialRow>(), quantity.name);
            return;
        }
        for (auto const& [traits, offset] : selector_.extra_parts()) {
            auto const found = std::ranges::find(traits->fields, quantity.name, &Field::name);
            if (found != traits->fields.end()) {
                own_.emplace_back(traits->number, *found);
                own_.back().second.offset += offset;
            }
        }
    }
    /// NaN: the model of this trial does not know it.
    [[nodiscard]] double of(TrialRows const& trials, std::size_t i) const {
        auto const& row = trials.rows[i];
        if (column_ != nullptr) {
            return number_at(bytes_of(row), *column_);
        }
        auto const found =
            std::ranges::find(own_, row.model, [](auto const& model_and_field) { return model_and_field.first; });
        auto const each = selector_.extra_bytes();
        return found == own_.end() || trials.extra.empty()
                   ? not_known
                   : number_at(std::span(trials.extra).subspan(i * each, each), found->second);
    }

  private:
    static double number_at(std::span<std::byte const> row, Field const& field) {
        return field.type == FieldType::real ? real_at(row, field) : static_cast<double>(integer_at(row, field));
    }

    ModelSelector selector_;
    Field const* column_ = nullptr;
    std::vector<std::pair<std::int64_t, Field>> own_;
};

Spread differences(TrialRows const& one, TrialRows const& two, Reader const& reader) {
    std::vector<double> all;
    for (std::size_t i = 0; i < one.rows.size(); ++i) {
        double const a = reader.of(one, i);
        double const b = reader.of(two, i);
        double const size = std::max(std::abs(a), std::abs(b));
        if (one.rows[i].verdict != two.rows[i].verdict || std::isnan(a) || std::isnan(b) || !(size > 0)) {
            continue;
        }
        all.push_back(a == b ? 0 : std::isinf(size) ? 1 : std::abs(a - b) / size);
    }
    return spread_of(std::move(all));
}

}  // namespace

StepError study_step_error(CampaignInput const& input, CampaignSpec const& spec, Plan const& plan,
                           std::span<PreparedWave const> waves) {
    std::vector<PreparedWave> others;
    others.reserve(waves.size());
    std::ranges::transform(waves, std::back_inserter(others), nudged);
    auto const usual = all_trials(spec, plan, waves);
    auto const finer = all_trials(parse_campaign(with(input, half_steps(spec.accuracy))), plan, waves);
    auto const near = all_trials(spec, plan, others);
    StepError error;
    error.trials = usual.rows.size();
    for (std::size_t i = 0; i < usual.rows.size(); ++i) {
        error.step_flips += usual.rows[i].verdict != finer.rows[i].verdict ? 1 : 0;
        error.rounding_flips += usual.rows[i].verdict != near.rows[i].verdict ? 1 : 0;
    }
    for (auto const& quantity : limit_quantities()) {
        Reader const reader(spec, quantity);
        QuantityError found{quantity.name, quantity.units, differences(usual, finer, reader),
                            differences(usual, near, reader)};
        if (found.step.count > 0) {
            error.quantities.push_back(std::move(found));
        }
    }
    return error;
}

}  // namespace overturn::cost
