#include "response/response.hpp"

#include "response/registry.hpp"

namespace overturn {

template <> Fields const& fields_of<Response>() {
    static auto const fields = [] {
        auto all = fields_of_base<Response, Outcome>();
        for (auto& field : all) {
            if (field.name == "verdict") {
                field.categories = verdict_categories();
            }
        }
        all.push_back(
            field<&Response::effects>("effects", "1", "bit mask of effects that ran: " + effect_bits()).always());
        all.push_back(category<&Response::model>("rung", "the model that computed the trial",
                                                 {model_categories().begin(), model_categories().end()})
                          .if_absent(unknown_category));
        all.push_back(category<&Response::reason>("reason", "why this model was required", reason_categories()));
        return all;
    }();
    return fields;
}

}  // namespace overturn
