// Requirement R-801, R-1002: a rare trial's answer is a pure function of its normals: the same bits alone and in a
// crowd.
#include "campaign/rare_problem.hpp"

#include "rare/detail/normals.hpp"
#include "support/campaigns.hpp"
#include "support/rare_answer.hpp"

namespace overturn {
namespace {

std::string const noise =
    "[waves]\nsource='filtered-noise'\nrms='1 m/s2'\nmodel='clough-penzien'\nground_frequency='0.5 Hz'\n"
    "ground_damping=0.5\nfilter_frequency='0.1 Hz'\ncount=2\nduration='10.23 s'\ntime_step='0.01 s'\n"
    "[[bodies]]\nname='block'\nmass='12.6 t'\nbase_width='0.9 m'\ncentre_height='1.045 m'\n"
    "inertia='uniform-block'\nfriction=0.5\nrestitution={distribution='lognormal',median=0.85,beta=0.1}\n"
    "[levels]\nmeasure='factor'\nvalues=[1.0]\n[rare]\n"
    "[[limits]]\nname='slides'\nquantity='peak_slip'\nabove='5 mm'\n";

TEST(RareProblem, AnswersOfManyAreThoseOfEachAlone) {
    auto const spec = testing::campaign_from(noise);
    std::vector<double> const factors{0.5, 3, 9};
    constexpr std::size_t count = 11;  // no multiple of any vector's lanes
    for (std::size_t const limit : {0, 1}) {
        RareProblem const problem(spec, 0, limit);
        auto const each = problem.normals();
        std::vector<double> normals(count * each);
        for (std::size_t i = 0; i < count; ++i) {
            rare::DrawKey const key{.seed = spec.seed, .phase = rare::Phase::crude, .index = i};
            rare::draw_normals(key, std::span(normals).subspan(i * each, each));
        }
        std::vector<rare::Answer> together(count * factors.size());

        problem.respond_each(normals, factors, together);

        std::size_t failed = 0;
        for (std::size_t a = 0; a < together.size(); ++a) {
            auto const own = std::span(normals).subspan(a / factors.size() * each, each);
            auto const alone = rare::respond_at(problem, own, factors[a % factors.size()]);
            EXPECT_EQ(together[a].driver, alone.driver) << a;
            EXPECT_EQ(together[a].failed, alone.failed) << a;
            EXPECT_EQ(together[a].undecided, alone.undecided) << a;
            failed += alone.failed ? 1 : 0;
        }
        EXPECT_GT(failed, 0U);
        EXPECT_LT(failed, together.size());
    }
}

}  // namespace
}  // namespace overturn
