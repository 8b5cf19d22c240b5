#include "rare/automatic.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"

namespace overturn::rare {
namespace {

/// Stages of one estimator's run among many.
class Named : public Workforce {
  public:
    Named(Workforce& workers, std::string name) : workers_(workers), name_(std::move(name)) {}
    [[nodiscard]] std::vector<std::byte> rows_of(Stage const& stage, Work const& work) override {
        auto named = stage;
        named.name = name_ + "-" + stage.name;
        return workers_.rows_of(named, work);
    }

  private:
    Workforce& workers_;
    std::string name_;
};

class Choice {
  public:
    Choice(Problem const& problem, std::span<double const> factors, Request const& request, Workforce& workers,
           Record* record)
        : problem_(problem),
          factors_(factors.begin(), factors.end()),
          request_(request),
          workers_(workers),
          record_(record),
          made_(factors.size()) {}

    std::vector<Estimate> by_itself() {
        auto left = look();
        if (problem_.frame() && !left.empty()) {
            left = mixture(left);
            // Where not even the pilot runs held, no other pulses will; a factor alone had its own already.
            bool const another = pilots_held();
            Places still;
            for (auto const f : left) {
                auto const untrusted = another ? mixture({f}) : Places{f};
                still.insert(still.end(), untrusted.begin(), untrusted.end());
            }
            left = still;
        }
        for (auto const f : left) {
            subset(f);
        }
        return std::move(made_);
    }

    std::vector<Estimate> by(Method method) {
        auto const all = everyone();
        if (method == Method::crude) {
            crude(all);
        } else if (method == Method::pulse_mixture) {
            auto const places = parted(all, certain_look);
            crude(places.nearly_certain);
            if (!places.others.empty()) {
                mixture(places.others);
            }
            for (auto& made : made_) {
                made.runs += certain_look;
            }
        } else {
            for (auto const f : all) {
                subset(f);
            }
        }
        return std::move(made_);
    }

  private:
    using Places = std::vector<std::size_t>;

    [[nodiscard]] Places everyone() const {
        Places all(factors_.size());
        for (std::size_t f = 0; f < all.size(); ++f) {
            all[f] = f;
        }
        return all;
    }
    [[nodiscard]] std::vector<double> factors_at(Places const& places) const {
        std::vector<double> factors;
        for (auto const f : places) {
            factors.push_back(factors_[f]);
        }
        return factors;
    }
    // Draws of their own for every run of an estimator.
    [[nodiscard]] Request request_for(std::size_t which) const {
        auto request = request_;
        request.problem = request.problem * (2 * most_factors) + which;
        return request;
    }

    [[nodiscard]] bool pilots_held() const {
        return std::any_of(made_.begin(), made_.end(), [](Estimate const& made) {
            return made.method == Method::pulse_mixture && made.state == State::trusted;
        });
    }

    // A limit that nearly every wave passes has no rare failures to fit pulses to: plain trials are enough.
    struct Parted {
        Places nearly_certain, others;
    };
    Parted parted(Places const& all, std::int64_t trials) {
        constexpr double nearly = 0.9;
        DrawKey const key{.seed = request_.seed, .problem = request_for(0).problem, .phase = Phase::scout, .level = 98};
        Named workers(workers_, "certain");
        auto const counts = count_failures(problem_, factors_, key, 0, trials, "plain", workers);
        Parted places;
        for (auto const f : all) {
            bool const most = static_cast<double>(counts[f].failed) >= nearly * static_cast<double>(trials);
            (most ? places.nearly_certain : places.others).push_back(f);
        }
        return places;
    }

    // Plain trials at all factors; answers those that are common. \return the others
    Places look() {
        DrawKey const key{.seed = request_.seed, .problem = request_for(0).problem, .phase = Phase::scout, .level = 99};
        Named workers(workers_, "look");
        plain_ = count_failures(problem_, factors_, key, 0, plain_look, "plain", workers);
        Places common;
        Places rare;
        for (std::size_t f = 0; f < factors_.size(); ++f) {
            bool const often = static_cast<double>(plain_[f].failed) >= common_probability * plain_look;
            (often ? common : rare).push_back(f);
        }
        crude(common);
        return rare;
    }

    void crude(Places const& places) {
        if (places.empty()) {
            return;
        }
        Named workers(workers_, "all");
        put(places, estimate_crude(problem_, factors_at(places), request_for(0), workers));
    }

    // \return what cannot be trusted
    Places mixture(Places const& places) {
        auto const factors = factors_at(places);
        auto const [least, most] = std::minmax_element(factors.begin(), factors.end());
        std::vector<Count> plain;
        for (auto const f : places) {
            plain.push_back(plain_.empty() ? Count{} : plain_[f]);
        }
        bool const together = places.size() > 1;
        Named workers(workers_, together ? "tail" : fmt::format("factor-{}", places.front()));
        auto result = estimate_pulse_mixture(problem_, factors, std::sqrt(*least * *most),
                                             request_for(together ? most_factors : places.front()), workers, plain);
        put(places, result.estimates);
        if (record_ != nullptr) {
            record_->mixtures.push_back(std::move(result));
        }
        Places left;
        std::copy_if(places.begin(), places.end(), std::back_inserter(left),
                     [&](std::size_t f) { return made_[f].state != State::trusted; });
        return left;
    }

    void subset(std::size_t f) {
        Named workers(workers_, fmt::format("factor-{}", f));
        auto result =
            estimate_subset(problem_, factors_[f], request_for(f), workers, {}, plain_.empty() ? Count{} : plain_[f]);
        put({f}, {result.estimate});
        if (record_ != nullptr) {
            record_->subsets.push_back(std::move(result));
        }
    }

    // Work that was done in vain counts too.
    void put(Places const& places, std::vector<Estimate> const& estimates) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            auto before = std::move(made_[places[i]]);
            auto& made = made_[places[i]] = estimates[i];
            made.runs += before.runs;
            made.tried = std::move(before.tried);
            if (!before.reason.empty()) {
                made.tried.push_back(fmt::format("{}, {} waves: {}, {}", name_of(before.method), before.runs,
                                                 name_of(before.state), before.reason));
            }
        }
    }

    Problem const& problem_;
    std::vector<double> factors_;
    Request request_;
    Workforce& workers_;
    Record* record_;
    std::vector<Estimate> made_;
    std::vector<Count> plain_;
};

}  // namespace

std::vector<Estimate> estimate(Problem const& problem, std::span<double const> factors, std::optional<Method> method,
                               Request const& request, Workforce& workers, Record* record) {
    OVERTURN_EXPECT(!factors.empty() && factors.size() < most_factors);
    Choice choice(problem, factors, request, workers, record);
    return method ? choice.by(*method) : choice.by_itself();
}

}  // namespace overturn::rare
