#include "response/model_selector.hpp"

namespace overturn {

Footing const& Scene::on_corners() {
    static Footing const footing;
    return footing;
}

}  // namespace overturn
