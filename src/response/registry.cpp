#include "response/registry.hpp"

#include <algorithm>
#include <array>

#include "contact/contact_model.hpp"
#include "core/error.hpp"
#include "rocking/rocking_models.hpp"
#include "spatial/spatial_model.hpp"

namespace overturn {

std::span<ModelEntry const> models() {
    static constexpr std::array entries{
        ModelEntry{rocking_traits, [](Accuracy const& a) { return make_rocking_model(a.rocking); }},
        ModelEntry{sliding_traits, [](Accuracy const& a) { return make_sliding_model(a.rocking); }},
        ModelEntry{contact_traits, [](Accuracy const& a) { return make_contact_model(a.contact); }},
        ModelEntry{spatial_traits, [](Accuracy const& a) { return make_spatial_model(a.contact); }},
    };
    return entries;
}

std::span<config::Entry<Effect> const> effects() {
    static auto const entries = [] {
        std::vector<config::Entry<Effect>> all;
        for (auto const& model : models()) {
            for (auto const& effect : model.traits().effects) {
                all.push_back({effect.name, effect.summary, effect.value});
            }
        }
        return all;
    }();
    return entries;
}

std::string effect_bits() {
    std::string text;
    for (auto const& effect : effects()) {
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", mask_of(effect.value), effect.name);
    }
    return text;
}

std::span<VerdictEntry const> verdicts() {
    static auto const entries = [] {
        std::vector<VerdictEntry> all(common_verdicts().begin(), common_verdicts().end());
        for (auto const& model : models()) {
            auto const& own = model.traits().verdicts;
            all.insert(all.end(), own.begin(), own.end());
        }
        return all;
    }();
    return entries;
}

VerdictEntry const& entry_of(Verdict verdict) {
    auto const all = verdicts();
    auto const found = std::ranges::find(all, verdict, &VerdictEntry::value);
    OVERTURN_EXPECT(found != all.end());
    return *found;
}

std::vector<Category> verdict_categories() {
    std::vector<Category> categories;
    for (auto const& entry : verdicts()) {
        categories.push_back({static_cast<std::int64_t>(entry.value), std::string(entry.name)});
    }
    return categories;
}

std::span<Category const> model_categories() {
    static auto const categories = [] {
        std::vector<Category> all{{0, "at-rest"}};
        for (auto const& model : models()) {
            all.push_back({model.traits().number, std::string(model.traits().name)});
        }
        return all;
    }();
    return categories;
}

std::span<ReasonEntry const> reasons() {
    static auto const entries = [] {
        std::vector<ReasonEntry> all{
            {no_reason, "none", "the simplest model supports all required effects"},
            {stated_reason, "stated", "its effects are stated in the campaign"},
            {left_out_reason, "left-out", "no model supports all required effects together: some are not simulated"}};
        for (auto const& model : models()) {
            auto const& own = model.traits().reasons;
            all.insert(all.end(), own.begin(), own.end());
        }
        return all;
    }();
    return entries;
}

std::vector<Category> reason_categories() {
    std::vector<Category> categories;
    for (auto const& entry : reasons()) {
        categories.push_back({entry.number, std::string(entry.name)});
    }
    return categories;
}

std::size_t model_place(std::int64_t model) {
    auto const all = model_categories();
    auto const found = std::ranges::find(all, model, &Category::value);
    OVERTURN_EXPECT(found != all.end());
    return static_cast<std::size_t>(found - all.begin());
}

}  // namespace overturn
